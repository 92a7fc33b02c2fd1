// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ffcontact/interface/labelled_facets.hpp"
#include "support/cracked.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two bodies as one mesh, the side low_z of the first above the side high_z of the
/// second.
struct Pair {
  JoinedSolids joined;
  Facets<3> faces;
  ContactSurface whole;
  std::vector<FacingPolygon> polygons;
  FacingSurface facing;

  Pair(const SolidMesh& upper, const SolidMesh& lower)
      : joined(joined_mesh<3>({upper, lower})), faces(facets_of(joined.mesh)) {
    whole = contact_surface(joined.mesh, faces, {low_z});
    polygons =
        facing_polygons(joined.mesh, faces, whole, {joined.label(1, high_z)});
    facing = facing_surface(joined.mesh, faces, whole, polygons);
  }
  const ContactSurface& surface() const { return facing.surface; }
};

int random_count(Random& random) { return 1 + static_cast<int>(random() % 4); }

/// An upper brick on (0, 3) x (0, 2), turned about its axis along z, above a lower one of
/// other cells that may be larger or smaller than it. Shifts up to (1.5, 1) keep the axis
/// in both.
Pair random_pair(double turn, const Vector2d& shift, Random& random) {
  SolidMesh upper =
      random_brick({random_count(random), random_count(random), 1}, {0, 0, 0},
                   {3, 2, 1}, random);
  const Vector3d axis(1.5, 1, 0);
  upper.vertices = (Eigen::AngleAxisd(turn, Vector3d::UnitZ()).matrix() *
                    (upper.vertices.colwise() - axis))
                       .colwise() +
                   axis;
  return Pair(upper,
              random_brick({random_count(random), random_count(random), 1},
                           {shift.x(), shift.y(), -1}, {3, 2, 1}, random));
}

RC_GTEST_PROP(FacingSurface, polygons_lie_on_both_faces, (Random random)) {
  Pair pair = random_pair(*real(-1, 1), {*real(-1, 1), *real(-1, 1)}, random);
  const SolidMesh& mesh = pair.joined.mesh;
  for (const FacingPolygon& polygon : pair.polygons) {
    const int own = pair.whole.face[polygon.contact_face];
    const Matrix3d x = mesh.vertices(Eigen::all, pair.faces.vertices.col(own)),
                   y = mesh.vertices(Eigen::all, pair.faces.vertices.col(
                                                     polygon.opposite_face));
    RC_ASSERT((x * polygon.own - y * polygon.opposite).norm() < 1e-12);
    RC_ASSERT(polygon.own.minCoeff() > -1e-12);
    RC_ASSERT(polygon.opposite.minCoeff() > -1e-12);
    RC_ASSERT(polygon.distance.norm() < 1e-12);
    RC_ASSERT(
        (polygon.own_of_opposite * polygon.opposite - polygon.own).norm() <
        1e-11);
  }
}

/// Whatever part of either surface faces the other: what one body feels is what the other
/// does, as a force and as a moment, and a field that is linear in space opens nothing.
RC_GTEST_PROP(FacingSurface, carries_forces_moments_and_linear_fields,
              (Random random)) {
  const double turn = *rc::gen::arbitrary<bool>() ? 0.0 : *real(-1, 1);
  const Pair pair = random_pair(turn, {*real(-1, 1), *real(-1, 1)}, random);
  const SolidMesh& mesh = pair.joined.mesh;
  const ContactSurface& surface = pair.surface();
  const Matrix3d gradient = random_matrix(3, 3, random);
  const Vector3d shift = random_vector(3, random);
  const VectorXd linear = nodal_values(
      mesh, [&](const Vector3d& x) { return Vector3d(gradient * x + shift); });
  RC_ASSERT(contact_components(surface, linear).norm() < 1e-10 * linear.norm());

  const Matrix3Xd force = random_matrix(3, surface.node_count(), random);
  const VectorXd load = nodal_load(surface, force, 3 * mesh.vertices.cols());
  Vector3d sum = Vector3d::Zero(), moment = Vector3d::Zero();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vector3d F = load.segment<3>(3 * v), x = mesh.vertices.col(v);
    sum += F;
    moment += x.cross(F);
  }
  RC_ASSERT(sum.norm() < 1e-10 * force.norm());
  RC_ASSERT(moment.norm() < 1e-10 * force.norm());

  double area = 0;
  for (const FacingPolygon& polygon : pair.polygons) area += polygon.area;
  RC_ASSERT(std::abs(surface.area.sum() - area) < 1e-6 * area);
  for (const FacingPolygon& polygon : surface.polygons) {
    const Matrix3d x = mesh.vertices(
        Eigen::all,
        pair.faces.vertices.col(surface.face[polygon.contact_face]));
    const Matrix3d y = mesh.vertices(
        Eigen::all, pair.faces.vertices.col(polygon.opposite_face));
    RC_ASSERT((x * polygon.own - y * polygon.opposite).norm() < 1e-11);
    area -= polygon.area;
  }
  RC_ASSERT(area < 1e-5);
  for (int i = 0; i < surface.node_count(); ++i)
    visit_opposite(surface, i,
                   [](int, double weight) { RC_ASSERT(std::abs(weight) < 4); });
}

/// Work of forces on both bodies is that on the openings.
RC_GTEST_PROP(FacingSurface, forces_are_dual_to_openings, (Random random)) {
  const Pair pair = random_pair(*real(-1, 1), {*real(-1, 1), 0}, random);
  const ContactSurface& surface = pair.surface();
  const Matrix3Xd force = random_matrix(3, surface.node_count(), random);
  const VectorXd u = random_vector(
      static_cast<int>(3 * pair.joined.mesh.vertices.cols()), random);
  const double work = nodal_load(surface, force, u.size()).dot(u);
  RC_ASSERT(std::abs(work -
                     contact_components(surface, u).cwiseProduct(force).sum()) <
            1e-10 * (1 + std::abs(work)));
}

/// int phi over the faces of a label [N/MPa, vertices].
VectorXd areas_at(const SolidMesh& mesh, const Facets<3>& faces, int label) {
  VectorXd area = VectorXd::Zero(mesh.vertices.cols());
  for (int f : labelled_facets(mesh, faces, {label}))
    for (int v : faces.vertices.col(f))
      area[v] += facet_measure(mesh, faces, f) / 3;
  return area;
}

/// Where both surfaces end together a uniform pressure loads both as it should, vertex by
/// vertex.
RC_GTEST_PROP(FacingSurface, passes_a_uniform_pressure, (Random random)) {
  const Pair pair = random_pair(0, {0, 0}, random);
  const ContactSurface& surface = pair.surface();
  const SolidMesh& mesh = pair.joined.mesh;
  Matrix3Xd force = Matrix3Xd::Zero(3, surface.node_count());
  force.row(0) = -surface.area.transpose();
  const VectorXd load = nodal_load(surface, force, 3 * mesh.vertices.cols());
  const VectorXd own = areas_at(mesh, pair.faces, low_z),
                 other =
                     areas_at(mesh, pair.faces, pair.joined.label(1, high_z));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    RC_ASSERT(std::abs(load[3 * v + 2] - own[v] + other[v]) < 1e-11);
    RC_ASSERT(std::abs(load[3 * v]) + std::abs(load[3 * v + 1]) < 1e-12);
  }
}

TEST(FacingSurface, follows_the_facing_vertex_where_meshes_match) {
  const SolidMesh upper = brick({3, 2, 1}, {3, 2, 1});
  SolidMesh lower = brick({3, 2, 2}, {3, 2, 2});
  lower.vertices.row(2).array() -= 2.25;
  const Pair pair(upper, lower);
  const SolidMesh& mesh = pair.joined.mesh;
  ASSERT_EQ(pair.surface().node_count(), 12);
  for (int i = 0; i < 12; ++i) {
    int vertices = 0;
    visit_opposite(pair.surface(), i, [&](int vertex, double weight) {
      ++vertices;
      EXPECT_EQ(weight, 1);
      const Vector3d x = mesh.vertices.col(pair.surface().vertex[i]),
                     y = mesh.vertices.col(vertex);
      EXPECT_LT((x - y - Vector3d(0, 0, 0.25)).norm(), 1e-15);
    });
    EXPECT_EQ(vertices, 1);
    EXPECT_NEAR(pair.facing.gap[i], 0.25, 1e-14);
  }
}

/// Nodes far from what is faced would carry what they do not feel.
TEST(FacingSurface, has_no_nodes_where_little_of_their_faces_is_faced) {
  SolidMesh lower = brick({2, 1, 1}, {1, 1, 1});
  lower.vertices.row(0).array() += 0.8;
  lower.vertices.row(2).array() -= 1;
  const Pair pair(brick({1, 1, 1}, {1, 1, 1}), lower);
  ASSERT_EQ(pair.surface().node_count(), 2);
  for (int v : pair.surface().vertex)
    EXPECT_EQ(pair.joined.mesh.vertices(0, v), 1);
  EXPECT_NEAR(pair.surface().area.sum(), 0.2, 1e-14);
}

/// The gap at a node of a plane that is tilted against the other one is the distance
/// there.
TEST(FacingSurface, gap_of_tilted_planes_is_the_distance) {
  const SolidMesh upper = brick({3, 2, 1}, {3, 2, 1});
  SolidMesh lower = brick({5, 4, 1}, {5, 4, 1});
  for (auto x : lower.vertices.colwise())
    x = Vector3d(x.x() - 1, x.y() - 1, x.z() - 1 - 0.1 * x.x() - 0.05 * x.y());
  const Pair pair(upper, lower);
  for (int i = 0; i < pair.surface().node_count(); ++i) {
    const Vector3d x = pair.joined.mesh.vertices.col(pair.surface().vertex[i]);
    EXPECT_NEAR(pair.facing.gap[i], 0.1 * (x.x() + 1) + 0.05 * (x.y() + 1),
                1e-13);
  }
}

/// Of two slabs, one above a part of the other, the upper face of the upper one is faced;
/// lower faces look away.
TEST(FacingSurface, pairs_the_nearest_face) {
  SolidMesh slabs = joined_mesh<3>({brick({4, 4, 1}, {3, 2, 0.2}),
                                    brick({2, 3, 1}, {1.5, 2, 0.2})})
                        .mesh;
  for (int v = 0; v < slabs.vertex_count(); ++v)
    slabs.vertices(2, v) -= v < 50 ? 1.0 : 0.3;
  for (int& label : slabs.boundary_label) {
    label -= label > 7 ? 7 : 0;
    if (label == low_z) label = high_z;
  }
  const Pair pair(brick({3, 2, 1}, {3, 2, 1}), slabs);
  double area = 0;
  for (const FacingPolygon& polygon : pair.polygons) {
    area += polygon.area;
    const double x =
        (pair.joined.mesh.vertices(
             Eigen::all, pair.faces.vertices.col(polygon.opposite_face)) *
         polygon.opposite)
            .row(0)
            .mean();
    EXPECT_NEAR(polygon.distance.mean(), x < 1.5 ? 0.1 : 0.8, 1e-12);
  }
  EXPECT_NEAR(area, 6, 1e-12);
}

/// The surface is 0.1 inside one sheet, and 0.06 above the next.
TEST(FacingSurface, overlaps_come_before_what_is_in_front) {
  SolidMesh low = brick({2, 2, 1}, {3, 2, 0.19}),
            high = brick({1, 2, 1}, {3, 2, 0.15}),
            upper = brick({2, 3, 1}, {3, 2, 1});
  high.vertices.row(2).array() += 0.2;
  upper.vertices.row(2).array() += 0.25;
  SolidMesh sheets = joined(low, high);
  for (int& label : sheets.boundary_label)
    if (label > 10) label -= 10;
  EXPECT_TRUE((Pair(upper, sheets).facing.gap.array() + 0.1).isZero(1e-13));
}

/// A sheet of a stack: its place across z, its lower and its upper side.
struct Sheet {
  Vector2d low, high;
  double below, above;
  bool covers(const Vector3d& x) const {
    return (x.head<2>().array() > low.array()).all() &&
           (x.head<2>().array() < high.array()).all();
  }
};

/// Sheets one above the other, some of which touch; all are on (1, 2) x (1, 2).
std::vector<Sheet> random_sheets(Random& random) {
  const Uniform part{0, 1};
  std::vector<Sheet> sheets(2 + random() % 3);
  double height = 0;
  for (Sheet& sheet : sheets) {
    if (random() % 2) height += 0.5 * part(random);
    const double below = height;
    height += 0.05 + 0.2 * part(random);
    sheet = {Vector2d(part(random), part(random)),
             Vector2d(2 + part(random), 2 + part(random)), below, height};
  }
  return sheets;
}

/// The stack as one mesh, turned: lower sides against upper ones.
struct SheetStack {
  JoinedSolids joined;
  SolidMesh mesh;
  std::vector<int> lower_sides, upper_sides;

  SheetStack(const std::vector<Sheet>& sheets, Random& random) {
    std::vector<SolidMesh> meshes;
    for (const Sheet& sheet : sheets) {
      const Vector3d low(sheet.low.x(), sheet.low.y(), sheet.below),
          high(sheet.high.x(), sheet.high.y(), sheet.above);
      meshes.push_back(
          random_brick({random_count(random), random_count(random), 1}, low,
                       high - low, random));
    }
    joined = joined_mesh(meshes);
    mesh = joined.mesh;
    const Vector3d axis = random_vector(3, random).normalized();
    mesh.vertices =
        Eigen::AngleAxisd(*real(-3, 3), axis).matrix() * mesh.vertices;
    for (int k = 1; k < joined.body_count(); ++k) {
      lower_sides.push_back(joined.label(k, low_z));
      upper_sides.push_back(joined.label(k - 1, high_z));
    }
  }
  int body(int vertex) const {
    const auto& first = joined.first_vertex;
    return static_cast<int>(
        std::upper_bound(first.begin(), first.end(), vertex) - first.begin() -
        1);
  }
};

/// Lower sides face what is in front of them, however thin their own body and whatever is
/// behind it.
RC_GTEST_PROP(FacingSurface, of_thin_sheets_are_those_in_front,
              (Random random)) {
  const std::vector<Sheet> sheets = random_sheets(random);
  const SheetStack stack(sheets, random);
  const Facets<3> faces = facets_of(stack.mesh);
  const ContactSurface whole =
      contact_surface(stack.mesh, faces, stack.lower_sides);
  for (const FacingPolygon& polygon :
       facing_polygons(stack.mesh, faces, whole, stack.upper_sides)) {
    if (polygon.area < 1e-10) continue;  // rounding at the rims of sheets
    const auto own = faces.vertices.col(whole.face[polygon.contact_face]);
    const Matrix3d at = stack.joined.mesh.vertices(Eigen::all, own);
    const Vector3d x = at * polygon.own.rowwise().mean();
    const int k = stack.body(own[0]);
    double gap = 10;
    for (int j = 0; j < k; ++j)
      if (sheets[j].covers(x))
        gap = std::min(gap, sheets[k].below - sheets[j].above);
    RC_ASSERT(std::abs(polygon.distance.mean() - gap) < 1e-9);
  }
}

/// Solids that overlap by more than their faces, or not at all, in either order.
RC_GTEST_PROP(FacingSurface, of_two_solids_is_the_same_from_either_of_them,
              (Random random)) {
  const double overlap = *real(-0.3, 0.8);
  const Pair pair(
      random_brick({1 + random_count(random), 1 + random_count(random), 1},
                   {0.5, 0.25, -overlap}, {2, 1.5, 1}, random),
      random_brick({1 + random_count(random), 1 + random_count(random), 1},
                   {0, 0, -1}, {3, 2, 1}, random));
  const SolidMesh& mesh = pair.joined.mesh;
  const ContactSurface other =
      contact_surface(mesh, pair.faces, {pair.joined.label(1, high_z)});
  const auto area = [&](const std::vector<FacingPolygon>& polygons) {
    double sum = 0;
    for (const FacingPolygon& polygon : polygons) {
      RC_ASSERT((polygon.distance.array() + overlap).isZero(1e-12));
      sum += polygon.area;
    }
    return sum;
  };
  RC_ASSERT(std::abs(area(pair.polygons) - 3) < 1e-9);
  RC_ASSERT(std::abs(area(facing_polygons(mesh, pair.faces, other, {low_z})) -
                     3) < 1e-9);
}

TEST(FacingSurface, of_a_crack_has_no_nodes_at_its_front) {
  SolidMesh bricks = brick({5, 5, 2}, {5, 5, 2});
  bricks = cracked<3>(bricks, 1, [](const Vector3d& x) {
    return (x.array().head<2>() - 2.5).abs().maxCoeff() < 1.5;
  });
  const Facets<3> faces = facets_of(bricks);
  const FacingSurface facing =
      test::facing(bricks, faces, crack_above, crack_below);
  ASSERT_EQ(facing.surface.node_count(), 4);  // of 16 vertices 12 are shared
  EXPECT_NEAR(facing.surface.area.sum(), 9, 1);
  EXPECT_TRUE(facing.gap.isZero(0));
  for (int i = 0; i < 4; ++i) {
    const Vector3d place = bricks.vertices.col(facing.surface.vertex[i]);
    EXPECT_LT((place.head<2>().array() - 2.5).abs().maxCoeff(), 1);
  }
}

/// Vertices that another multiplier holds have none, and their hats go to the others: forces
/// are the same, and the jump of linear fields is exact.
TEST(FacingSurface, has_no_nodes_where_it_is_glued) {
  SolidMesh below = brick({3, 5, 1}, {4, 3, 1});
  below.vertices.row(2).array() -= 1;
  const Pair pair(brick({4, 3, 1}, {4, 3, 1}), below);
  const SolidMesh& mesh = pair.joined.mesh;
  Flags glued(mesh.vertex_count(), 0);
  int count = 0;
  for (const int v : pair.surface().vertex)
    if (mesh.vertices(0, v) < 0.1) glued[v] = ++count > 0;
  const ContactSurface part =
      facing_surface(mesh, pair.faces, pair.whole, pair.polygons, glued)
          .surface;
  ASSERT_EQ(count, 4);
  EXPECT_EQ(part.node_count(), pair.surface().node_count() - count);
  EXPECT_NEAR(part.area.sum(), 12, 1e-12);
  for (const int v : part.vertex) EXPECT_EQ(glued[v], 0);
  VectorXd field(3 * mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    field.segment<3>(3 * v) = Vector3d(1, 2, 3) + 2 * mesh.vertices.col(v);
  EXPECT_LT(contact_components(part, field).norm(), 1e-12);
}

TEST(FacingSurface, tells_which_face_touches_its_own_surface) {
  const auto touching = [](const SolidMesh& mesh,
                           const std::vector<int>& labels) {
    const Facets<3> faces = facets_of(mesh);
    return touching_face(mesh, faces, contact_surface(mesh, faces, labels),
                         labels);
  };
  SolidMesh bricks = cracked<3>(brick({3, 3, 2}, {3, 3, 2}), 1,
                                [](const Vector3d& x) { return x.x() < 2; });
  EXPECT_GE(touching(bricks, {crack_above, crack_below}), 0);
  EXPECT_EQ(touching(bricks, {crack_above}), -1);
  EXPECT_EQ(touching(brick({2, 2, 1}, {2, 2, 0.01}), {low_z, high_z}), -1);
}

TEST(FacingSurface, refuses_what_faces_nothing) {
  SolidMesh lower = brick({1, 1, 1}, {1, 1, 1});
  lower.vertices.row(0).array() += 5;
  EXPECT_NE(refusal([&] {
              Pair(brick({1, 1, 1}, {1, 1, 1}), lower);
            }).find("faces a face of the opposite body"),
            std::string::npos);
}

}  // namespace
}  // namespace ffcontact
