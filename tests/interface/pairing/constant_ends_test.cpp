// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/constant_ends.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two rectangles 6 wide, one on the other, and the line of the upper one.
struct Rectangles {
  Bodies two;
  const ContactLine& line = two.problem.line;

  Rectangles(int upper, int lower)
      : two(bodies({shifted(rectangle(upper, 2, 6, 2), {0, 2}),
                    rectangle(lower, 2, 6, 2)},
                   {material(70e3, 0.3), material(70e3, 0.3)},
                   {{0, bottom, 1, top}})) {}

  const Problem& problem() const { return two.problem; }
  ContactLine with_constant_ends() const {
    return ffcontact::with_constant_ends(problem().mesh, problem().edges, line);
  }
  /// Without the ends left of a place.
  ContactLine without_ends(double left_of) const {
    const Mesh& mesh = problem().mesh;
    Flags held(mesh.vertex_count(), 0);
    for (int v = 0; v < mesh.vertex_count(); ++v)
      held[v] = mesh.place(v).x() < left_of;
    return ffcontact::without_ends(mesh, problem().edges, line, held);
  }
};

/// The jump of a field that is linear over both bodies is 0.
void expect_exact(const Mesh& mesh, const ContactLine& line) {
  VectorXd linear(2 * mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    linear.segment<2>(2 * v) = Vector2d(1, 2) + 3 * mesh.vertices.col(v);
  EXPECT_LT(contact_components(line, linear).norm(), 1e-12);
}

TEST(ConstantEnds, are_both_ends_of_a_line_that_does_not_match) {
  const Rectangles two(7, 5);
  const ContactLine line = two.with_constant_ends();
  EXPECT_EQ(two.line.node_count(), 8);
  ASSERT_EQ(line.node_count(), 6);
  EXPECT_EQ(line.edge_count(), 7);
  EXPECT_EQ(line.edge_node(0, 0), line.edge_node(1, 0));
  EXPECT_EQ(line.edge_node(0, 6), line.edge_node(1, 6));
  EXPECT_EQ(line.vertex, two.line.vertex.segment(1, 6));
  expect_exact(two.problem().mesh, line);
}

TEST(ConstantEnds, leave_lines_that_match_and_two_nodes) {
  EXPECT_EQ(Rectangles(5, 5).with_constant_ends().node_count(), 6);
  EXPECT_EQ(Rectangles(2, 3).with_constant_ends().node_count(), 2);
  EXPECT_EQ(Rectangles(1, 3).with_constant_ends().node_count(), 2);
}

TEST(ConstantEnds, are_left_out_at_vertices_that_are_held) {
  const Rectangles two(7, 5);
  const ContactLine line = two.without_ends(3);
  ASSERT_EQ(line.node_count(), 7);
  EXPECT_EQ(line.vertex, two.line.vertex.tail(7));
  EXPECT_EQ(line.edge_node(0, 0), line.edge_node(1, 0));
  EXPECT_NE(line.edge_node(0, 6), line.edge_node(1, 6));
  expect_exact(two.problem().mesh, line);
}

TEST(ConstantEnds, leave_an_edge_that_is_held_at_both_ends_a_node) {
  const Rectangles two(1, 3);
  EXPECT_EQ(two.without_ends(7).node_count(), 1);
  EXPECT_EQ(Rectangles(2, 3).without_ends(7).node_count(), 1);
  EXPECT_EQ(two.without_ends(-1).node_count(), 2);
}

}  // namespace
}  // namespace ffcontact
