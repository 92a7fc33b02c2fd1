// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/facing_traces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/facing.hpp"
#include "support/refusals.hpp"

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
