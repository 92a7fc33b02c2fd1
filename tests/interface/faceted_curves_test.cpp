// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/faceted_curves.hpp"

#include <gtest/gtest.h>

#include "ffcontact/interface/curve_directions.hpp"
#include "support/arcs.hpp"

namespace ffcontact {
namespace {

using namespace test;

std::vector<FacetedCurve> curves_of(const Mesh& mesh) {
  const Edges edges = edges_of(mesh);
  return faceted_curves(mesh, edges, contact_line(mesh, edges, {bottom}));
}

TEST(FacetedCurves, are_arcs_of_five_edges_or_more_that_turn_by_less_than_29) {
  EXPECT_EQ(curves_of(arc_body(even_angles(-0.5, 0.5, 10), 10)).size(), 1);
  EXPECT_EQ(curves_of(hollow_body(even_angles(-0.5, 0.5, 10), 10)).size(), 1);
  EXPECT_EQ(curves_of(arc_body(even_angles(-0.5, 0.5, 4), 10)).size(), 0);
  // 13, 12, 8 and 6 edges a circle
  for (const int n : {13, 12, 8, 6}) {
    const double most = 2.5 * 2 * M_PI / n;
    const auto found = curves_of(arc_body(even_angles(-most, most, 5), 10));
    EXPECT_EQ(found.size(), n > 12) << n;
  }
}

TEST(FacetedCurves, are_named_by_the_edge_in_their_middle) {
  const Mesh mesh = arc_body(even_angles(-0.5, 0.5, 10), 10);
  const Edges edges = edges_of(mesh);
  const auto found = curves_of(mesh);
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found[0].edges, 10);
  EXPECT_NEAR(found[0].largest_turn, 0.1, 1e-12);
  const Vector2d middle = mesh.vertices.col(edges.vertices(0, found[0].edge));
  EXPECT_LT((middle - Vector2d(0, -10)).norm(), 1e-12);
}

TEST(FacetedCurves, are_none_along_one_direction_or_one_node_a_vertex) {
  const Mesh mesh = arc_body(even_angles(-0.5, 0.5, 10), 10);
  const Edges edges = edges_of(mesh);
  ContactLine line = curved_contact_line(mesh, edges, {bottom});
  VectorXd gap(line.node_count());
  for (int i = 0; i < gap.size(); ++i)
    gap[i] = mesh.vertices(1, line.vertex[i]) + 10;
  line = with_one_direction_a_curve(mesh, edges, line, gap);
  EXPECT_TRUE(faceted_curves(mesh, edges, line).empty());
}

TEST(FacetedCurves, are_no_straight_sides_chamfers_or_sides_of_several_edges) {
  EXPECT_TRUE(curves_of(rectangle(8, 2, 8, 2)).empty());
  // a punch with chamfers of 45 degrees, and of 20
  for (const double slope : {1.0, 0.36}) {
    Mesh punch = rectangle(12, 2, 12, 4);
    for (auto x : punch.vertices.colwise())
      x[1] += (1 - x[1] / 4) * slope * std::max(0.0, std::abs(x[0] - 6) - 4);
    EXPECT_TRUE(curves_of(punch).empty()) << slope;
  }
  // twenty sides a circle, each of two edges
  Mesh sides = arc_body(even_angles(-1.25, 1.25, 16), 10);
  for (int v = 1; v + 1 < sides.vertex_count(); ++v)
    if (v % 2 == 1 && v < 17)
      sides.vertices.col(v) =
          0.5 * (sides.vertices.col(v - 1) + sides.vertices.col(v + 1));
  EXPECT_TRUE(curves_of(sides).empty());
}

}  // namespace
}  // namespace ffcontact
