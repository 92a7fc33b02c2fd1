// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/curve_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactLine curved_line(const Mesh& mesh, const std::vector<int>& labels) {
  const Edges edges = edges_of(mesh);
  return contact_line(mesh, edges, labels, BoundaryCurves(mesh, edges));
}

void expect_unchanged(const ContactLine& line, const ContactLine& directed) {
  EXPECT_EQ(directed.normal, line.normal);
  EXPECT_EQ(directed.edge_node, line.edge_node);
}

/// A block whose lower side is an arc of a circle around (centre, radius), from x = 0 to
/// x = 4, and straight before and after.
struct Round {
  Mesh mesh;
  ContactLine line;

  Round(int n, double centre, double radius, double from = 0, double to = 4)
      : mesh(rectangle(n, n, 4, 3)) {
    const auto bottom_at = [&](double x) {
      const double at = std::min(std::max(x, from), to) - centre,
                   y = radius - std::sqrt(radius * radius - at * at);
      return y + (x - centre - at) * at / std::sqrt(radius * radius - at * at);
    };
    for (int v = 0; v < mesh.vertex_count(); ++v)
      mesh.vertices(1, v) +=
          (1 - mesh.vertices(1, v) / 3) * bottom_at(mesh.vertices(0, v));
    line = curved_line(mesh, {bottom});
  }
  double height(int node) const { return mesh.vertices(1, line.vertex[node]); }
  VectorXd heights(double factor = 1) const {
    VectorXd gap(line.node_count());
    for (int i = 0; i < gap.size(); ++i) gap[i] = factor * height(i);
    return gap;
  }
  ContactLine directed(const VectorXd& gap) const {
    return with_one_direction_a_curve(mesh, line, gap);
  }
};

TEST(CurveDirections, are_the_normal_where_the_gap_is_smallest) {
  // at a vertex, between vertices, at an end
  for (const double centre : {2.0, 1.9, 1.3, 0.0}) {
    const Round round(10, centre, 8);
    ASSERT_TRUE(turns(round.line));
    const ContactLine line = round.directed(round.heights());
    EXPECT_FALSE(turns(line));
    EXPECT_LT((line.normal.col(0) - Vector2d(0, -1)).norm(), 1e-3) << centre;
  }
}

TEST(CurveDirections, are_the_curve_s_where_it_fits_its_foundation) {
  const Round round(10, 2, 8);
  EXPECT_FALSE(turns(round.directed(round.heights(0.6))));
  expect_unchanged(round.line, round.directed(round.heights(0.4)));
  expect_unchanged(round.line, round.directed(round.heights(0)));
}

TEST(CurveDirections, are_the_curve_s_where_it_turns_too_far_or_is_hollow) {
  const Round half(40, 0, 4.1);  // up to 77 degrees
  ASSERT_TRUE(turns(half.line));
  expect_unchanged(half.line, half.directed(half.heights()));
  Round hollow(10, 2, 8);
  for (int v = 0; v < hollow.mesh.vertex_count(); ++v)
    hollow.mesh.vertices(1, v) *= hollow.mesh.vertices(1, v) < 1 ? -1 : 1;
  hollow.line = curved_line(hollow.mesh, {bottom});
  ASSERT_TRUE(turns(hollow.line));
  expect_unchanged(hollow.line,
                   hollow.directed(VectorXd::Zero(hollow.line.node_count())));
}

TEST(CurveDirections,
     are_those_of_a_straight_line_that_the_curve_goes_on_from) {
  const Round flat(20, 1, 8, 1, 4);
  ASSERT_EQ(flat.line.node_count(), 21);
  ASSERT_TRUE(turns(flat.line));
  const ContactLine line = flat.directed(flat.heights());
  for (int i = 0; i < line.node_count(); ++i)
    EXPECT_EQ(line.normal.col(i), flat.line.normal.col(0));
}

TEST(CurveDirections, are_the_curve_s_between_two_straight_lines) {
  const Round tip(40, 2, 3, 1, 3);
  ASSERT_EQ(tip.line.node_count(), 41);
  ASSERT_TRUE(turns(tip.line));
  expect_unchanged(tip.line, tip.directed(tip.heights()));
}

TEST(CurveDirections, are_each_curve_s_own) {
  const Round two(20, 2, 8);
  Round block = two;  // with an arc on top, too, that fits its foundation
  for (int v = 0; v < two.mesh.vertex_count(); ++v) {
    const double x = two.mesh.vertices(0, v) - 2;
    block.mesh.vertices(1, v) -= rectangle(20, 20, 4, 3).vertices(1, v) / 3 *
                                 (8 - std::sqrt(64 - x * x));
  }
  block.line = curved_line(block.mesh, {bottom, top});
  ASSERT_EQ(block.line.node_count(), 2 * 21);
  VectorXd gap = VectorXd::Zero(42);
  int lower = 0;
  for (int i = 0; i < 42; ++i)
    if (block.height(i) < 1.5) gap[i] = block.height(i), ++lower;
  ASSERT_EQ(lower, 21);
  const ContactLine line = block.directed(gap);
  ASSERT_EQ(line.node_count(), 42);
  for (int i = 0; i < 42; ++i) {
    const Vector2d own =
        block.height(i) < 1.5 ? Vector2d(0, -1) : block.line.normal.col(i);
    EXPECT_LT((line.normal.col(i) - own).norm(), 1e-6);
  }
}

TEST(CurveDirections, of_straight_lines_are_left_alone) {
  const Mesh mesh = rectangle(4, 4, 4, 4);
  const ContactLine line = contact_line(mesh, edges_of(mesh), {bottom, right});
  EXPECT_FALSE(turns(line));
  EXPECT_EQ(
      with_one_direction_a_curve(mesh, line, VectorXd::LinSpaced(10, 0, 1))
          .normal,
      line.normal);
  EXPECT_EQ(refusal([&] {
              with_one_direction_a_curve(mesh, line, VectorXd::Zero(3));
            }),
            "gap has 3 values where 10 are needed");
}

}  // namespace
}  // namespace ffcontact
