// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ffcontact/interface/labelled_facets.hpp"
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

TEST(FacingSurface, refuses_what_faces_nothing_and_shared_vertices) {
  SolidMesh lower = brick({1, 1, 1}, {1, 1, 1});
  lower.vertices.row(0).array() += 5;
  EXPECT_NE(refusal([&] {
              Pair(brick({1, 1, 1}, {1, 1, 1}), lower);
            }).find("faces a face of the opposite body"),
            std::string::npos);
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  const Facets<3> faces = facets_of(mesh);
  EXPECT_NE(refusal([&] {
              facing_polygons(mesh, faces,
                              contact_surface(mesh, faces, {low_z}), {low_x});
            }).find("is on both contact surfaces"),
            std::string::npos);
}

}  // namespace
}  // namespace ffcontact
