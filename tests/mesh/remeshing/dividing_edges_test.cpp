// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/dividing_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// V - E + F = 2 of the surface of a body, each edge between two of its faces.
RC_GTEST_PROP(DividingEdges, close_the_surface_of_a_body, (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  const DividingFaces dividing =
      dividing_faces(mesh, faces, VectorXi::Zero(mesh.cell_count()));
  const std::vector<DividingEdge> edges = dividing_edges(faces, dividing);
  std::set<int> vertices;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [ends, around] = edges[e];
    RC_ASSERT(ends[0] < ends[1]);
    if (e > 0) RC_ASSERT(edges[e - 1].vertices < ends);
    RC_ASSERT(around.size() == 2u);
    RC_ASSERT(around[0] < around[1]);
    for (const int k : around)
      for (const int v : ends)
        RC_ASSERT((faces.vertices.col(dividing.face[k]).array() == v).any());
    vertices.insert(ends.begin(), ends.end());
  }
  RC_ASSERT(static_cast<int>(vertices.size()) + dividing.count() ==
            static_cast<int>(edges.size()) + 2);
}

/// Where a face between two regions meets the boundary three faces do.
TEST(DividingEdges, have_three_faces_on_the_rim_of_an_inner_one) {
  const SolidMesh mesh = brick({4, 3, 2}, {4, 3, 2});
  const Facets<3> faces = facets_of(mesh);
  VectorXi regions(mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    regions[t] = mesh.vertices(2, mesh.cells(3, t)) > 1;
  const DividingFaces dividing = dividing_faces(mesh, faces, regions);
  int of_three = 0;
  for (const DividingEdge& edge : dividing_edges(faces, dividing)) {
    if (edge.faces.size() != 3) continue;
    ++of_three;
    for (const int v : edge.vertices) EXPECT_EQ(mesh.vertices(2, v), 1);
  }
  EXPECT_EQ(of_three, 2 * (4 + 3));
}

}  // namespace
}  // namespace ffcontact
