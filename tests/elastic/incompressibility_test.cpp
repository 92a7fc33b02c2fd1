// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/incompressibility.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/cells.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// int C eps(u) : eps(v) by the strains of unit displacements.
template <int dim>
RowMatrix stiffness_by_strains(const SimplexMesh<dim>& mesh,
                               const HookeTensors<dim>& hooke) {
  const Index n = dim * mesh.vertex_count();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(voigt_size<dim>, n);
    for (const int v : mesh.cells.col(t))
      for (int c = 0; c < dim; ++c)
        B.col(dim * v + c) = strain(mesh, VectorXd::Unit(n, dim * v + c), t);
    K += signed_volume(mesh, t) * B.transpose() * hooke[t] * B;
  }
  return K.sparseView();
}

template <int dim>
double told(const SimplexMesh<dim>& mesh, const HookeTensors<dim>& hooke) {
  const RowMatrix K = stiffness_by_strains<dim>(mesh, hooke);
  return largest_bulk_over_shear(
      mesh, elastic_system(K, VectorXd::Zero(K.rows()), dim), 0,
      mesh.vertex_count());
}

template <int dim>
double told(const SimplexMesh<dim>& mesh, double lambda, double G) {
  return told<dim>(
      mesh, HookeTensors<dim>(mesh.cell_count(), isotropic<dim>(lambda, G)));
}

RC_GTEST_PROP(Incompressibility, is_told_by_the_matrix, (Random random)) {
  const double ratio = std::pow(10, *real(-1, 5)), G = *real(1e-3, 1e3);
  RC_ASSERT(std::abs(told(irregular(4, 3, 4, 3, random), ratio * G, G) / ratio -
                     1) < 1e-5);
  RC_ASSERT(std::abs(told(irregular_solid(random), ratio * G, G) / ratio - 1) <
            1e-5);
}

RC_GTEST_PROP(Incompressibility, is_that_of_the_least_compressible_part,
              (Random random)) {
  const Mesh mesh = irregular(8, 4, 8, 4, random);
  Hooke hooke(mesh.cell_count(), isotropic(1, 1));
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (centroid_of(mesh, t)[0] > 4) hooke[t] = isotropic(500, 1);
  RC_ASSERT(std::abs(told<2>(mesh, hooke) / 500 - 1) < 1e-5);
}

TEST(Incompressibility, is_that_of_the_vertices_that_are_asked) {
  const Mesh mesh = rectangle(8, 8, 8, 8);
  Hooke hooke(mesh.cell_count(), isotropic(1, 1));
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (centroid_of(mesh, t)[1] > 4) hooke[t] = isotropic(500, 1);
  const RowMatrix K = stiffness_by_strains<2>(mesh, hooke);
  const ElasticSystem system = elastic_system(K, VectorXd::Zero(K.rows()));
  EXPECT_NEAR(largest_bulk_over_shear(mesh, system, 0, 27), 1, 1e-9);
  EXPECT_NEAR(largest_bulk_over_shear(mesh, system, 54, 81), 500, 1e-5);
}

TEST(Incompressibility, is_told_by_a_single_triangle) {
  CellCorners<2> corners;
  corners << 0, 3, 1, 0, 0.5, 2;
  EXPECT_NEAR(told(single_triangle(corners), 77, 1) / 77, 1, 1e-9);
}

TEST(Incompressibility, is_not_told_by_other_materials) {
  Random random(4);
  const Mesh mesh = irregular(5, 4, 5, 4, random);
  Eigen::Matrix3d C = isotropic(300, 1);
  C(2, 2) = 40;
  EXPECT_EQ(told<2>(mesh, Hooke(mesh.cell_count(), C)), 0);
}

}  // namespace
}  // namespace ffcontact
