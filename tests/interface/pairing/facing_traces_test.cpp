// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_traces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cracked.hpp"
#include "support/facing.hpp"
#include "support/refusals.hpp"
#include "support/uniform.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(FacingTraces, that_match_face_edge_by_edge) {
  const Facing two(shifted(rectangle(4, 2, 4, 2), {0, 2.5}),
                   rectangle(4, 2, 4, 2));
  ASSERT_EQ(two.traces.pieces.size(), 4u);
  EXPECT_TRUE(two.line.matches());
  for (int e = 0; e < 4; ++e) {
    const FacingPiece& piece = two.traces.pieces[e];
    EXPECT_EQ(piece.contact_edge, e);
    EXPECT_EQ(two.line.opposite_edge[e], piece.opposite_edge);
    EXPECT_LT((two.on(piece.opposite_edge, 1) - two.on(two.line.edge[e], 0) +
               Vector2d(0, 0.5))
                  .norm(),
              1e-15);
  }
  EXPECT_EQ(two.traces.gap, VectorXd::Constant(5, 0.5));
  for (int i = 0; i < 5; ++i)
    visit_opposite(two.line, i, [&](int vertex, double weight) {
      EXPECT_EQ(weight, 1);
      EXPECT_EQ(two.joined.mesh.vertices(0, vertex),
                two.joined.mesh.vertices(0, two.line.vertex[i]));
      EXPECT_EQ(two.joined.mesh.vertices(1, vertex), 2);
    });
}

RC_GTEST_PROP(FacingTraces,
              pieces_cover_the_line_without_holes_and_lie_opposite,
              (Random random)) {
  const Facing two = random_rows(random);
  int e = 0;
  double end = 0;
  for (const FacingPiece& piece : two.traces.pieces) {
    if (end == 1) {
      ++e;
      end = 0;
    }
    RC_ASSERT(piece.contact_edge == e && piece.begin == end &&
              piece.end > piece.begin);
    RC_ASSERT(piece.opposite_begin > piece.opposite_end);
    RC_ASSERT(piece.opposite_begin <= 1 && piece.opposite_end >= 0);
    RC_ASSERT((two.on(two.line.edge[e], piece.begin) -
               two.on(piece.opposite_edge, piece.opposite_begin))
                  .norm() < 1e-9);
    RC_ASSERT((two.on(two.line.edge[e], piece.end) -
               two.on(piece.opposite_edge, piece.opposite_end))
                  .norm() < 1e-9);
    end = piece.end;
  }
  RC_ASSERT(e + 1 == two.line.edge_count() && end == 1);
  RC_ASSERT(two.traces.gap.isZero(0));
}

RC_GTEST_PROP(FacingTraces,
              of_a_round_body_are_paired_along_its_turning_normals,
              (Random random)) {
  Mesh round = moved(rectangle(6, 2, 4, 2), 0.6, 0.2, random);
  for (int v = 0; v < round.vertex_count(); ++v)
    round.vertices.col(v) << 1 + round.vertices(0, v),
        4 + round.vertices(1, v) + 0.02 * std::pow(round.vertices(0, v) - 2, 2);
  const Facing two(round, with_random_rows(5, 2, 6, 3, random), true);
  for (const FacingPiece& piece : two.traces.pieces)
    for (const bool last : {false, true}) {
      const double s = last ? piece.end : piece.begin,
                   opposite = last ? piece.opposite_end : piece.opposite_begin;
      const Vector2d n = two.direction(piece.contact_edge, s),
                     ray = two.on(piece.opposite_edge, opposite) -
                           two.on(two.line.edge[piece.contact_edge], s);
      RC_ASSERT(std::abs(n.x() * ray.y() - n.y() * ray.x()) < 1e-9);
      const int node = two.line.edge_node(last, piece.contact_edge);
      if (s == last)
        RC_ASSERT(std::abs(two.traces.gap[node] - ray.norm()) < 1e-9);
    }
}

TEST(FacingTraces,
     gap_is_measured_along_the_normal_and_negative_where_bodies_overlap) {
  Mesh lower = rectangle(3, 1, 6, 3);
  for (int v = 0; v < lower.vertex_count(); ++v)
    if (lower.vertices(1, v) == 3)
      lower.vertices(1, v) += 0.1 * (lower.vertices(0, v) - 3);
  const Facing two(shifted(rectangle(4, 1, 4, 2), {1, 3}), lower);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(two.traces.gap[i], -0.1 * (i - 2), 1e-14);
}

TEST(FacingTraces, distances_within_the_rounding_of_coordinates_are_no_gap) {
  const double unit = 1e-6;
  const auto rounded = [&](Mesh mesh) {
    mesh = rotated(mesh, 0.3);
    mesh.vertices = (mesh.vertices / unit).array().round().matrix() * unit;
    return mesh;
  };
  const Facing two(rounded(shifted(rectangle(7, 2, 4, 2), {0, 2})),
                   rounded(rectangle(9, 2, 4, 2)));
  EXPECT_TRUE(two.traces.gap.isZero(0));
  const Facing apart(rounded(shifted(rectangle(7, 2, 4, 2), {0, 2.0001})),
                     rounded(rectangle(9, 2, 4, 2)));
  EXPECT_GT(apart.traces.gap.minCoeff(), 0.9e-4);
}

TEST(FacingTraces, takes_the_nearest_of_several_edges_on_a_ray) {
  Mesh lower =
      joined(rectangle(2, 2, 4, 2), shifted(rectangle(3, 1, 4, 1), {0, -3}));
  lower.boundary_label.tail(8).array() -= 10;
  const Facing two(shifted(rectangle(4, 1, 4, 1), {0, 2.25}), lower);
  EXPECT_EQ(two.traces.gap, VectorXd::Constant(5, 0.25));
  ASSERT_EQ(two.traces.pieces.size(),
            4u);  // the vertices of the lower edges cut nothing
  for (const FacingPiece& piece : two.traces.pieces) {
    const int own = two.line.edge[piece.contact_edge];
    EXPECT_NEAR(two.on(own, piece.begin).x(),
                two.on(piece.opposite_edge, piece.opposite_begin).x(), 1e-14);
    EXPECT_NEAR(two.on(own, piece.end).x(),
                two.on(piece.opposite_edge, piece.opposite_end).x(), 1e-14);
  }
}

TEST(FacingTraces, gap_above_a_step_is_that_of_the_higher_side) {
  Mesh lower =
      joined(rectangle(1, 1, 2, 2), shifted(rectangle(1, 1, 2, 1.5), {2, 0}));
  lower.boundary_label.tail(4).array() -= 10;
  const Facing two(shifted(rectangle(2, 1, 4, 1), {0, 2.25}), lower);
  EXPECT_EQ(two.traces.gap, Vector3d(0.25, 0.25, 0.75));
}

/// A plate of a stack, from left to right and from low to high.
struct Plate {
  double left, right, low, high;
};

/// Plates thinner than some of their edges, one above the other; some touch. All of them
/// are where x is between 1 and 2.
std::vector<Plate> random_plates(Random& random) {
  const Uniform part{0, 1};
  std::vector<Plate> plates(2 + random() % 4);
  double height = 0;
  for (Plate& plate : plates) {
    if (random() % 2) height += 0.5 * part(random);
    const double low = height;
    height += 0.05 + 0.3 * part(random);
    plate = {part(random), 2 + 2 * part(random), low, height};
  }
  return plates;
}

Mesh mesh_of(const Plate& plate, Random& random) {
  const int cells = 1 + static_cast<int>(random() % 20);
  return shifted(with_random_rows(cells, 1, plate.right - plate.left,
                                  plate.high - plate.low, random),
                 {plate.left, plate.low});
}

/// The gap of a piece at its middle.
double middle_gap(const FacingPiece& piece) {
  return 0.5 * (piece.gap_begin + piece.gap_end);
}

/// Lower sides face what is in front of them, however thin their own body and whatever is
/// behind it.
RC_GTEST_PROP(FacingTraces, of_thin_plates_are_those_in_front,
              (Random random)) {
  const std::vector<Plate> plates = random_plates(random);
  const int count = static_cast<int>(plates.size());
  std::vector<Mesh> meshes;
  for (const Plate& plate : plates) meshes.push_back(mesh_of(plate, random));
  const JoinedMesh flat = joined_mesh(meshes);
  std::vector<int> lower_sides, upper_sides;
  for (int k = 1; k < count; ++k) {
    lower_sides.push_back(flat.label(k, bottom));
    upper_sides.push_back(flat.label(k - 1, top));
  }
  const Mesh mesh = rotated(flat.mesh, *real(-3, 3));
  const Edges edges = edges_of(mesh);
  const ContactLine line = contact_line(mesh, edges, lower_sides);
  const FacingTraces traces = facing_traces(mesh, edges, line, upper_sides);
  std::vector<double> covered(count, 0);
  for (const FacingPiece& piece : traces.pieces) {
    const int edge = line.edge[piece.contact_edge],
              first = edges.vertices(0, edge), second = edges.vertices(1, edge);
    const Vector2d a = flat.mesh.vertices.col(first),
                   d = flat.mesh.vertices.col(second) - a,
                   x = a + 0.5 * (piece.begin + piece.end) * d;
    const auto next = std::upper_bound(flat.first_vertex.begin(),
                                       flat.first_vertex.end(), first);
    const int k = static_cast<int>(next - flat.first_vertex.begin()) - 1;
    covered[k] += (piece.end - piece.begin) * d.norm();
    double gap = 10;
    for (int j = 0; j < k; ++j)
      if (plates[j].left < x.x() && x.x() < plates[j].right)
        gap = std::min(gap, plates[k].low - plates[j].high);
    RC_ASSERT(std::abs(middle_gap(piece) - gap) < 1e-9);
  }
  double left = plates[0].left, right = plates[0].right;
  for (int k = 1; k < count; ++k) {
    const double faced =
        std::min(right, plates[k].right) - std::max(left, plates[k].left);
    RC_ASSERT(std::abs(covered[k] - faced) < 1e-3);
    left = std::min(left, plates[k].left);
    right = std::max(right, plates[k].right);
  }
}

/// Bodies that overlap by more than their edges, or not at all, in either order.
RC_GTEST_PROP(FacingTraces, of_two_bodies_are_the_same_from_either_of_them,
              (Random random)) {
  const double overlap = *real(-0.5, 0.9), angle = *real(-3, 3);
  const int upper = 1 + static_cast<int>(random() % 40),
            lower = 1 + static_cast<int>(random() % 40);
  const Facing two(rotated(shifted(with_random_rows(upper, 2, 4, 1, random),
                                   {1, 3 - overlap}),
                           angle),
                   rotated(with_random_rows(lower, 2, 6, 3, random), angle));
  const ContactLine other =
      contact_line(two.joined.mesh, two.edges, {two.joined.label(1, top)});
  const FacingTraces turned =
      facing_traces(two.joined.mesh, two.edges, other, {bottom});
  const auto length = [&](const ContactLine& line, const FacingTraces& traces) {
    double sum = 0;
    for (const FacingPiece& piece : traces.pieces) {
      RC_ASSERT(std::abs(middle_gap(piece) + overlap) < 1e-12);
      const int edge = line.edge[piece.contact_edge];
      sum += (piece.end - piece.begin) *
             edge_vector(two.joined.mesh, two.edges, edge).norm();
    }
    return sum;
  };
  RC_ASSERT(std::abs(length(two.line, two.traces) - 4) < 1e-3);
  RC_ASSERT(std::abs(length(other, turned) - 4) < 1e-3);
}

/// The line is 0.1 inside one plate, and 0.06 above the next.
TEST(FacingTraces, overlaps_come_before_what_is_in_front) {
  Mesh plates = joined(rectangle(3, 1, 3, 0.19),
                       shifted(rectangle(2, 1, 3, 0.15), {0, 0.2}));
  plates.boundary_label.tail(6).array() -= 10;
  const Facing two(shifted(rectangle(4, 1, 3, 1), {0, 0.25}), plates);
  EXPECT_TRUE((two.traces.gap.array() + 0.1).isZero(1e-14));
}

/// An edge in front of a joint of two bodies stays one where these all but touch.
TEST(FacingTraces, have_no_holes_that_are_too_narrow) {
  const auto edges_above = [](double joint) {
    Mesh lower = joined(rectangle(1, 1, 2, 2),
                        shifted(rectangle(1, 1, 2, 2), {2 + joint, 0}));
    lower.boundary_label.tail(4).array() -= 10;
    return Facing(shifted(rectangle(3, 1, 4, 1), {0, 2}), lower)
        .line.edge_count();
  };
  EXPECT_EQ(edges_above(0), 3);
  EXPECT_EQ(edges_above(M_PI * 1e-5), 3);
  EXPECT_EQ(edges_above(0.1), 4);
}

/// A slit between 1 and 5 in a rectangle.
Mesh slit() {
  return cracked<2>(rectangle(6, 4, 6, 4), 2,
                    [](const Vector2d& x) { return x.x() > 1 && x.x() < 5; });
}

TEST(FacingTraces, of_a_crack_are_its_faces_without_the_edges_at_its_tips) {
  const Mesh mesh = slit();
  const Edges edges = edges_of(mesh);
  for (const bool above : {false, true}) {
    const ContactLine whole =
        contact_line(mesh, edges, {above ? crack_above : crack_below});
    const FacingTraces traces =
        facing_traces(mesh, edges, whole, {above ? crack_below : crack_above});
    EXPECT_EQ(whole.edge_count(), 4);
    const ContactLine line = facing_line(mesh, edges, whole, traces);
    EXPECT_EQ(line.edge_count(), 2);
    EXPECT_TRUE(line.matches());
    ASSERT_EQ(line.node_count(), 3);
    EXPECT_TRUE(facing_gap(line).isZero(0));
    for (int i = 0; i < 3; ++i)
      visit_opposite(line, i, [&](int vertex, double weight) {
        EXPECT_EQ(weight, 1);
        EXPECT_NE(vertex, line.vertex[i]);
        EXPECT_EQ(mesh.vertices.col(vertex), mesh.vertices.col(line.vertex[i]));
      });
  }
}

TEST(FacingTraces, of_a_crack_need_an_edge_that_does_not_end_at_a_tip) {
  const Mesh mesh = cracked<2>(rectangle(6, 4, 6, 4), 2, [](const Vector2d& x) {
    return x.x() > 2 && x.x() < 4;
  });
  const Edges edges = edges_of(mesh);
  const ContactLine line = contact_line(mesh, edges, {crack_above});
  const std::string sentence =
      refusal([&] { facing_traces(mesh, edges, line, {crack_below}); });
  EXPECT_TRUE(says(sentence, "divide the faces of a crack")) << sentence;
}

TEST(FacingTraces, tell_where_a_line_touches_itself) {
  const auto touches_itself = [](const Mesh& mesh,
                                 const std::vector<int>& labels) {
    const Edges edges = edges_of(mesh);
    const ContactLine line = contact_line(mesh, edges, labels);
    return touching_place(mesh, edges, line, labels).has_value();
  };
  EXPECT_TRUE(touches_itself(slit(), {crack_above, crack_below}));
  EXPECT_FALSE(touches_itself(slit(), {crack_above}));
  EXPECT_FALSE(touches_itself(rectangle(4, 1, 4, 0.01), {bottom, top}));
  const Mesh low = rectangle(2, 1, 2, 1);
  const JoinedMesh beside = joined_mesh<2>({low, shifted(low, {2, 0})}),
                   above = joined_mesh<2>({low, shifted(low, {0.5, 1})});
  EXPECT_FALSE(touches_itself(beside.mesh, {bottom, beside.label(1, bottom)}));
  EXPECT_FALSE(touches_itself(above.mesh, {bottom, above.label(1, top)}));
  EXPECT_TRUE(touches_itself(above.mesh, {top, above.label(1, bottom)}));
}

TEST(FacingTraces, refuses_a_line_that_faces_nothing) {
  const auto refusal_at = [&](double x) {
    return refusal([&] {
      Facing(shifted(rectangle(2, 1, 2, 1), {x, 1}), rectangle(2, 1, 2, 1));
    });
  };
  EXPECT_EQ(refusal_at(0), "accepted");
  EXPECT_EQ(refusal_at(1.5), "accepted");
  EXPECT_TRUE(says(refusal_at(2),
                   "no point of the contact line, as (2.5, 1), faces an edge"))
      << refusal_at(2);
}

}  // namespace
}  // namespace ffcontact
