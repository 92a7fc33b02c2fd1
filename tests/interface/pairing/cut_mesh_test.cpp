// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/cut_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Up to three cuts on half of the boundary edges; corners have two edges.
EdgeCuts random_cuts(const Mesh& mesh, const Edges& edges, Random& random) {
  EdgeCuts cuts;
  int next = mesh.vertex_count();
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e) || random() % 2 == 0) continue;
    CutEdge& places = cuts.of_edge[e];
    places = {{0.0, edges.vertices(0, e)}, {1.0, edges.vertices(1, e)}};
    const int count = static_cast<int>(random() % 4);
    for (int k = 1; k <= count; ++k)
      places.emplace((k + 0.3) / (count + 1), next++);
  }
  return cuts;
}

RC_GTEST_PROP(CutMesh, is_the_same_body, (Random random)) {
  const Mesh old = irregular(3, 2, 3, 2, random);
  const Edges edges = edges_of(old);
  const CutMesh cut = cut_mesh(old, edges, random_cuts(old, edges, random));
  require_valid(cut.mesh);
  const Edges new_edges = edges_of(cut.mesh);  // every boundary edge is listed
  RC_ASSERT((cut.mesh.vertices -
             old.vertices * MatrixXd(cut.vertex_weights).transpose())
                .norm() < 1e-14);
  VectorXd area = VectorXd::Zero(old.cell_count());
  for (int t = 0; t < cut.mesh.cell_count(); ++t)
    area[cut.parent[t]] += signed_area(cut.mesh, t);
  for (int t = 0; t < old.cell_count(); ++t) {
    RC_ASSERT(cut.parent[t] == t);
    RC_ASSERT(std::abs(area[t] - signed_area(old, t)) < 1e-14);
  }
  VectorXd length = VectorXd::Zero(old.boundary.cols());
  for (Index b = 0; b < cut.mesh.boundary.cols(); ++b) {
    const int parent = cut.parent_boundary[b];
    length[parent] += boundary_measure(cut.mesh, b);
    RC_ASSERT(cut.mesh.boundary_label[b] == old.boundary_label[parent]);
  }
  for (Index b = 0; b < old.boundary.cols(); ++b)
    RC_ASSERT(std::abs(length[b] - boundary_measure(old, b)) < 1e-14);
}

TEST(CutMesh, has_the_origin_of_the_mesh) {
  Mesh old = rectangle(1, 1, 1, 1);
  old.origin = Vector2d(1024, -3);
  EXPECT_EQ(cut_mesh(old, edges_of(old), {}).mesh.origin, old.origin);
}

}  // namespace
}  // namespace ffcontact
