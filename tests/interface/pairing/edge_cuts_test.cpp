// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/edge_cuts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/meshes.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A piece between places on an edge of a line and, backwards, on one of the mesh.
FacingPiece piece(double begin, double end, int opposite_edge,
                  double opposite_begin, double opposite_end) {
  FacingPiece result{};
  result.begin = begin;
  result.end = end;
  result.opposite_edge = opposite_edge;
  result.opposite_begin = opposite_begin;
  result.opposite_end = opposite_end;
  return result;
}

/// Three pieces of edge 5 of the mesh, on the edges 2 and 3, meet at 0.25 and 0.6; one
/// place is told twice with rounding.
TEST(EdgeCuts, are_the_ends_of_pieces_each_once) {
  const Mesh mesh = rectangle(3, 2, 3, 2);
  const Edges edges = edges_of(mesh);
  ContactLine line;
  line.edge = VectorXi::Constant(1, 5);
  const EdgeCuts cuts =
      edge_cuts(mesh, edges, line,
                {piece(0, 0.25, 2, 1, 0), piece(0.25 + 1e-13, 0.6, 3, 1, 0.5),
                 piece(0.6, 1, 3, 0.5 - 1e-13, 0)});
  ASSERT_EQ(cuts.of_edge.size(), 3u);
  EXPECT_EQ(cuts.of_edge.at(5).size(), 4u);
  EXPECT_EQ(cuts.of_edge.at(3).size(), 3u);
  EXPECT_EQ(cuts.of_edge.at(2).size(), 2u);
  for (const int e : {2, 3, 5}) {
    EXPECT_EQ(cuts.vertex_at(e, 0), edges.vertices(0, e));
    EXPECT_EQ(cuts.vertex_at(e, 1), edges.vertices(1, e));
  }
  const std::set<int> made{cuts.vertex_at(3, 0.5), cuts.vertex_at(5, 0.25),
                           cuts.vertex_at(5, 0.6)};
  EXPECT_EQ(made, std::set<int>({12, 13, 14}));  // after those of the mesh
  EXPECT_EQ(cuts.vertex_at(5, 0.25 - 9e-11), cuts.vertex_at(5, 0.25 + 9e-11));
  EXPECT_TRUE(cuts.lies_on(cuts.vertex_at(5, 0.6), 5));
  EXPECT_FALSE(cuts.lies_on(cuts.vertex_at(5, 0.6), 3));
  EXPECT_FALSE(cuts.lies_on(cuts.vertex_at(5, 0.6), 0));
}

}  // namespace
}  // namespace ffcontact
