// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/vertex_order.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/meshes.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The same matrix, all first components first.
RowMatrix by_components(const RowMatrix& A, int dim) {
  const Index n = A.rows() / dim;
  Eigen::PermutationMatrix<Dynamic> order(A.rows());
  for (Index dof = 0; dof < A.rows(); ++dof)
    order.indices()[dof] = static_cast<int>(dof % dim * n + dof / dim);
  return order * A * order.transpose();
}

template <int d>
std::string judged(const SimplexMesh<d>& mesh, const RowMatrix& A) {
  return refusal([&] { require_order_of_vertices(A, mesh.vertices); });
}

template <int d>
RowMatrix stiffness_of(const SimplexMesh<d>& mesh) {
  return stiffness<d>(mesh,
                      HookeTensors<d>(mesh.cell_count(), isotropic<d>(50, 40)));
}

template <int d>
void told_from_blocks(const SimplexMesh<d>& mesh) {
  const RowMatrix A = stiffness_of<d>(mesh);
  EXPECT_EQ(judged<d>(mesh, A), "accepted");
  EXPECT_TRUE(says(judged<d>(mesh, by_components(A, d)),
                   "A is numbered by components, u"));
}

TEST(VertexOrder, tells_blocks_of_scalar_spaces) {
  std::mt19937 random(1);
  const Mesh plane = rectangle(3, 2, 12, 8);
  const SolidMesh solid = brick({9, 7, 6}, {9, 7, 6});
  told_from_blocks<2>(plane);
  told_from_blocks<2>(renumbered(plane, random).mesh);
  told_from_blocks<3>(solid);
  told_from_blocks<3>(shuffled(solid, random));
}

TEST(VertexOrder, takes_every_tiny_body) {
  std::mt19937 random(2);
  for (int n = 1; n < 5; ++n)
    for (int k = 0; k < 20; ++k) {
      const Mesh plane = renumbered(rectangle(8, 1, n, 1), random).mesh;
      const SolidMesh solid = shuffled(brick({n, 1, 1}, {8.0, 1, 1}), random);
      EXPECT_EQ(judged<2>(plane, stiffness_of<2>(plane)), "accepted");
      EXPECT_EQ(judged<3>(solid, stiffness_of<3>(solid)), "accepted");
    }
}

}  // namespace
}  // namespace ffcontact
