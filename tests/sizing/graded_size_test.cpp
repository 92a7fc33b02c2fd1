// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/graded_size.hpp"

#include <gtest/gtest.h>

#include "ffcontact/mesh/topology.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact::test {
namespace {

/// Each edge bounds both of its ends until nothing changes.
template <int dim>
VectorXd by_relaxation(const SimplexMesh<dim>& mesh, const Matrix2Xi& edges,
                       VectorXd size, double gradation) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto ends : edges.colwise())
      for (int k = 0; k < 2; ++k) {
        const int v = ends[k], w = ends[1 - k];
        const double length =
            (mesh.vertices.col(v) - mesh.vertices.col(w)).norm();
        if (size[w] <= size[v] + gradation * length) continue;
        size[w] = size[v] + gradation * length;
        changed = true;
      }
  }
  return size;
}

/// Pairs of the vertices of each cell, some of them several times.
Matrix2Xi sides_of_cells(const SolidMesh& mesh) {
  Matrix2Xi edges(2, 6 * mesh.cells.cols());
  Index next = 0;
  for (const auto cell : mesh.cells.colwise())
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 4; ++j) edges.col(next++) << cell[i], cell[j];
  return edges;
}

RC_GTEST_PROP(GradedSize, is_the_largest_field_below, (Random random)) {
  const double gradation = *real(0.05, 2);
  const Mesh mesh = irregular(6, 4, 6, 4, random);
  const Matrix2Xi edges = topology_of(mesh).facets.vertices;
  const VectorXd size =
      random_vector(mesh.vertex_count(), random).array().square() + 0.01;
  const VectorXd graded = graded_size(mesh, edges, size, gradation);
  RC_ASSERT((graded - by_relaxation(mesh, edges, size, gradation)).norm() <=
            1e-14);
  const SolidMesh solid = irregular_solid(random);
  const VectorXd any =
      random_vector(solid.vertex_count(), random).array().square() + 0.01;
  const Matrix2Xi sides = sides_of_cells(solid);
  RC_ASSERT((graded_size(solid, sides, any, gradation) -
             by_relaxation(solid, sides, any, gradation))
                .norm() <= 1e-14);
}

/// Of one small size in a corner: it grows with the way along the sides.
TEST(GradedSize, grows_with_the_distance) {
  const Mesh mesh = rectangle(8, 1, 16, 1);
  VectorXd size = VectorXd::Constant(mesh.vertex_count(), 5);
  size[0] = 1;
  const VectorXd graded =
      graded_size(mesh, topology_of(mesh).facets.vertices, size, 0.25);
  for (int i = 0; i <= 8; ++i)
    EXPECT_DOUBLE_EQ(graded[i], std::min(5.0, 1 + 0.25 * 2 * i));
}

}  // namespace
}  // namespace ffcontact::test
