// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/bonded_line.hpp"

#include <gtest/gtest.h>

#include <set>

#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/interface/facing_groups.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "support/arcs.hpp"
#include "support/bonded.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material any = material(1, 0.3);

TEST(BondedLine, has_one_node_a_vertex) {
  const Mesh mesh = rotated(rectangle(5, 3, 5, 3), 0.3);
  const Edges edges = edges_of(mesh);
  const ContactLine line = bonded_line(mesh, edges, {bottom, right, top, left});
  EXPECT_EQ(line.node_count(), 16);
  EXPECT_EQ(std::set<int>(line.vertex.begin(), line.vertex.end()).size(), 16u);
  int corners = 0;
  for (int e = 0; e < line.edge_count(); ++e) corners += turns(line, e);
  EXPECT_EQ(corners, 8);  // edges beside the four
  EXPECT_LT((line.normal.colwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
}

TEST(BondedLine, has_one_normal_along_a_straight_line) {
  const Mesh mesh = rotated(rectangle(9, 2, 5, 3), 0.3);
  EXPECT_FALSE(turns(bonded_line(mesh, edges_of(mesh), {bottom})));
}

Bodies blocks(int upper, int lower) {
  return bonded_bodies(
      {shifted(rectangle(upper, 2, 6, 4), {0, 5}), rectangle(lower, 2, 6, 5)},
      {any, any}, {{0, bottom, 1, top}});
}

TEST(BondedLine, has_constant_ends_where_it_does_not_match) {
  EXPECT_EQ(blocks(5, 5).problem.line.node_count(), 6);
  EXPECT_EQ(blocks(5, 3).problem.line.node_count(), 4);
  EXPECT_EQ(blocks(3, 5).problem.line.node_count(), 2);
  EXPECT_EQ(blocks(2, 5).problem.line.node_count(), 2);
  EXPECT_EQ(blocks(1, 5).problem.line.node_count(), 2);
  const ContactLine line = blocks(5, 3).problem.line;
  EXPECT_TRUE(is_constant_on(line, 0) && is_constant_on(line, 4));
  EXPECT_TRUE(ends_at_its_node(line, 1, 0) && ends_at_its_node(line, 0, 4));
  EXPECT_FALSE(ends_at_its_node(line, 0, 0) || ends_at_its_node(line, 1, 4));
  EXPECT_EQ(line.abscissa, Vector4d(1.2, 2.4, 3.6, 4.8));
}

TEST(BondedLine, feels_no_jump_of_linear_fields) {
  for (const auto& [upper, lower] :
       {std::pair(5, 3), std::pair(3, 5), std::pair(11, 7), std::pair(4, 4)}) {
    const Problem problem = blocks(upper, lower).problem;
    const Matrix2Xd jumps = contact_components(
        problem.line, nodal_values(problem.mesh, linear_field));
    EXPECT_LT(jumps.cwiseAbs().maxCoeff(), 1e-16);
  }
}

TEST(BondedLine, without_turns_has_the_normals_of_its_edges) {
  const Mesh mesh = arc_body(even_angles(-1, 1, 6), 10);
  const Edges edges = edges_of(mesh);
  const ContactLine line = bonded_line(mesh, edges, {bottom, right});
  const UnturnedLine unturned =
      unturned_line(mesh, edges, line, Flags(line.node_count(), 1));
  EXPECT_FALSE(turns(unturned.line));
  EXPECT_EQ(unturned.line.edge, line.edge);
  EXPECT_EQ(unturned.parent.head(line.node_count()),
            VectorXi::LinSpaced(line.node_count(), 0, line.node_count() - 1));
  EXPECT_EQ(unturned.line.vertex, line.vertex(unturned.parent));
  for (int e = 0; e < line.edge_count(); ++e)
    EXPECT_LT(
        (unturned.line.edge_normal(e) - edge_normal(mesh, edges, line.edge[e]))
            .norm(),
        1e-12);
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end)
      EXPECT_EQ(unturned.parent[unturned.line.edge_node(end, e)],
                line.edge_node(end, e));
}

TEST(FacingGroups, are_the_vertices_that_face_each_other) {
  const Problem problem = blocks(4, 4).problem;
  const auto groups = facing_groups(problem.line);
  ASSERT_EQ(groups.size(), 5u);
  for (const std::vector<int>& group : groups) {
    ASSERT_EQ(group.size(), 2u);
    EXPECT_LT((problem.mesh.vertices.col(group[0]) -
               problem.mesh.vertices.col(group[1]))
                  .norm(),
              1e-12);
  }
}

}  // namespace
}  // namespace ffcontact
