// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/system_parts.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/cut_meshes.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// What is prescribed at the vertices on x = 0, or, in a part, at those of its facets there.
template <int dim>
std::vector<char> prescribed_of(const SimplexMesh<dim>& mesh) {
  std::vector<char> prescribed(dim * mesh.vertex_count(), 0);
  for (int e = 0; e < mesh.boundary.cols(); ++e) {
    bool is_low = true;
    for (int v : mesh.boundary.col(e)) is_low &= mesh.vertices(0, v) == 0;
    if (!is_low) continue;
    for (int v : mesh.boundary.col(e))
      for (int c = 0; c < dim; ++c) prescribed[dim * v + c] = 1;
  }
  return prescribed;
}

/// As FreeFEM assembles it over the cells of a mesh, with a force of its own in each.
/// @param moved  are prescribed displacements others than 0?
template <int dim>
ElasticSystem system_of(const SimplexMesh<dim>& mesh, bool moved, double tgv) {
  RowMatrix A = stiffness(
      mesh, HookeTensors<dim>(mesh.cell_count(), isotropic<dim>(60, 40)));
  VectorXd b = VectorXd::Zero(A.rows());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      b.template segment<dim>(dim * mesh.cells(k, t)) +=
          mesh.corner(t, 0).array().square().matrix();
  const std::vector<char> prescribed = prescribed_of(mesh);
  for (int dof = 0; dof < A.rows(); ++dof) {
    if (!prescribed[dof]) continue;
    if (tgv < 0)
      for (RowMatrix::InnerIterator e(A, dof); e; ++e) e.valueRef() = 0;
    A.coeffRef(dof, dof) = tgv < 0 ? 1 : tgv;
    const double value = moved ? 0.01 * mesh.vertices(1, dof / dim) : 0;
    b[dof] = tgv < 0 ? value : tgv * value;
  }
  return elastic_system(A, b, dim);
}

/// Rows and columns of free dofs.
MatrixXd free_part(const ElasticSystem& system) {
  MatrixXd K = system.stiffness;
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (system.prescribed[dof]) {
      K.row(dof).setZero();
      K.col(dof).setZero();
    }
  return K;
}

template <int dim>
void expect_the_system_of_the_whole(const SimplexMesh<dim>& mesh, bool moved,
                                    double tgv, Random& random) {
  const auto parts = cut(mesh, 1 + static_cast<int>(random() % 4), random);
  std::vector<ElasticSystem> systems;
  std::vector<std::vector<int>> vertex;
  for (const auto& part : parts) {
    systems.push_back(system_of(part.mesh, moved, tgv));
    vertex.push_back(part.numbers.vertex);
  }
  const ElasticSystem whole = system_of(mesh, moved, tgv),
                      joined = joined_parts(systems, vertex);
  const double size = free_part(whole).cwiseAbs().maxCoeff();
  EXPECT_EQ(joined.prescribed, whole.prescribed);
  EXPECT_EQ(joined.dimension, dim);
  EXPECT_LE(
      (joined.prescribed_value - whole.prescribed_value).cwiseAbs().maxCoeff(),
      1e-15);
  EXPECT_LE((free_part(joined) - free_part(whole)).cwiseAbs().maxCoeff(),
            1e-13 * size);
  EXPECT_LE((joined.load - whole.load).cwiseAbs().maxCoeff(), 1e-12 * size);
}

RC_GTEST_PROP(SystemParts, sum_up_to_the_system_of_the_whole, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const bool moved = random() % 2;
  const double tgv = random() % 2 ? 1e30 : -1;
  expect_the_system_of_the_whole(renumbered(rectangle(4, 3, 4, 3), random).mesh,
                                 moved, tgv, random);
  expect_the_system_of_the_whole(shuffled(brick({2, 2, 3}, {2, 2, 3}), random),
                                 moved, tgv, random);
}

TEST(SystemParts, that_disagree_are_refused) {
  const Mesh mesh = rectangle(2, 2, 1, 1);
  std::vector<int> all(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) all[v] = v;
  const ElasticSystem at_rest = system_of(mesh, false, 1e30),
                      moved = system_of(mesh, true, 1e30);
  EXPECT_THROW(joined_parts({at_rest, moved}, {all, all}),
               std::invalid_argument);
  all.pop_back();
  EXPECT_THROW(joined_parts({at_rest}, {all}), std::invalid_argument);
}

}  // namespace
}  // namespace ffcontact
