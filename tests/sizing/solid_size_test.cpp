// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/mesh/ridges.hpp"
#include "ffcontact/sizing/cell_shape.hpp"
#include "ffcontact/sizing/graded_size.hpp"
#include "ffcontact/sizing/optimal_size.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

VectorXd random_solid_errors(Index n, Random& random) {
  return (2.3 * random_vector(n, random)).array().exp() / 100;
}

double squared_solid_error(const VectorXd& error, const VectorXd& rate,
                           const VectorXd& ratio) {
  return (error.array().square() * ratio.array().pow(2 * rate.array())).sum();
}

/// sum r_E^-3
double tetrahedron_count(const VectorXd& ratio) {
  return ratio.array().cube().inverse().sum();
}

/// Ratios times the number with which they have the wanted error.
VectorXd scaled_to_error(const VectorXd& error, const VectorXd& rate,
                         const VectorXd& ratio, double wanted) {
  double low = 1e-3, high = 1e3;
  while (high / low > 1 + 1e-14) {
    const double middle = std::sqrt(low * high);
    const double square = squared_solid_error(error, rate, middle * ratio);
    (square < wanted * wanted ? low : high) = middle;
  }
  return low * ratio;
}

RC_GTEST_PROP(SolidSizeRatios,
              need_fewer_tetrahedra_than_any_other_sizes_of_that_error,
              (Random random)) {
  const int n = *rc::gen::inRange(2, 60);
  const VectorXd error = random_solid_errors(n, random),
                 rate = 0.65 + 0.35 * random_vector(n, random).array();
  const double wanted = *real(1e-3, 1);
  const VectorXd ratio = size_ratios<3>(error, rate, wanted);
  RC_ASSERT(
      std::abs(std::sqrt(squared_solid_error(error, rate, ratio)) / wanted -
               1) < 1e-11);
  for (double size : {1e-3, 0.1, 1.0}) {
    const VectorXd other = ratio.cwiseProduct(
        (size * random_vector(n, random)).array().exp().matrix());
    RC_ASSERT(tetrahedron_count(scaled_to_error(error, rate, other, wanted)) >=
              tetrahedron_count(ratio) * (1 - 1e-11));
  }
}

RC_GTEST_PROP(SolidSizeRatios, give_all_new_tetrahedra_the_same_error,
              (Random random)) {
  // eps_E^2 r_E^2 is that of r_E^-3 new ones.
  const int n = *rc::gen::inRange(2, 60);
  const VectorXd error = random_solid_errors(n, random);
  const VectorXd ratio = size_ratios<3>(error, VectorXd::Ones(n), 0.01);
  const Eigen::ArrayXd share = error.array().square() * ratio.array().pow(5);
  RC_ASSERT(share.maxCoeff() / share.minCoeff() - 1 < 1e-10);
}

Matrix2Xi edges_of_solid(const SolidMesh& mesh) {
  return ridges_of(mesh, facets_of(mesh)).vertices;
}

SizeSettings solid_target(double wanted) {
  SizeSettings settings;
  settings.target = wanted;
  return settings;
}

TEST(SolidSize, of_an_even_mesh_counts_regular_tetrahedra_of_the_wanted_error) {
  const SolidMesh mesh = brick({4, 4, 4}, {8, 8, 8});
  const int n = mesh.cell_count();
  const VectorXd error = VectorXd::Constant(n, 0.005);
  // a sixth of a cube: 36 |E|^2 = a^6, sum of l^2 = 10 a^2
  const double quality = std::sqrt(6 * std::cbrt(72 / 36.0) / 10);
  for (double part : {0.8, 0.5, 0.4}) {
    const OptimalSize result =
        optimal_size(mesh, edges_of_solid(mesh), error, {},
                     solid_target(part * error.norm()));
    EXPECT_NEAR(result.predicted_error / result.wanted, 1, 1e-9);
    // eps goes with the size and the quality, 0.9 of new tetrahedra
    const double expected =
        n * std::pow(quality / 0.9 * error.norm() / result.wanted, 3);
    EXPECT_NEAR(result.predicted_count / expected, 1, 1e-9);
    const double h =
        std::cbrt(512 / (result.predicted_count * std::sqrt(2) / 12)) / 0.9;
    EXPECT_NEAR(result.size.minCoeff() / h, 1, 1e-9);
    EXPECT_NEAR(result.size.maxCoeff() / h, 1, 1e-9);
  }
}

RC_GTEST_PROP(SolidSize, is_bounded_and_graded, (Random random)) {
  const SolidMesh mesh = brick({3, 4, 3}, {6, 8, 6});
  const Matrix2Xi edges = edges_of_solid(mesh);
  const VectorXd error = random_solid_errors(mesh.cell_count(), random);
  SizeSettings settings = solid_target(std::min(0.9, 0.3 * error.norm()));
  settings.smallest = 0.3;
  settings.largest = 1.5;
  settings.gradation = 0.4;
  const OptimalSize result = optimal_size(mesh, edges, error, {}, settings);
  RC_ASSERT(result.size.minCoeff() >= 0.3);
  RC_ASSERT(result.size.maxCoeff() <= 1.5);
  for (Index e = 0; e < edges.cols(); ++e) {
    const int v = edges(0, e), w = edges(1, e);
    const double length = (mesh.vertices.col(v) - mesh.vertices.col(w)).norm();
    RC_ASSERT(std::abs(result.size[v] - result.size[w]) <=
              0.4 * length * (1 + 1e-14));
  }
}

TEST(SolidSize, is_small_where_the_error_is_large) {
  const SolidMesh mesh = brick({4, 4, 4}, {8, 8, 8});
  VectorXd error(mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    error[t] =
        1e-3 *
        (1 +
         4 * (mesh.vertices(Eigen::all, mesh.cells.col(t)).row(0).maxCoeff() <=
              2));
  const VectorXd size = optimal_size(mesh, edges_of_solid(mesh), error, {},
                                     solid_target(0.5 * error.norm()))
                            .size;
  // without gradation r goes with eps_E^(-2/5)
  EXPECT_NEAR(size.minCoeff() / size.maxCoeff(), std::pow(5, -0.4), 0.05);
}

TEST(ShapeQuality, of_tetrahedra_is_one_for_regular_ones) {
  SolidMesh mesh;
  mesh.vertices =
      3 * (Matrix<double, 3, 4>() << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1)
              .finished();
  mesh.cells = (Matrix<int, 4, 1>() << 0, 1, 2, 3).finished();
  ASSERT_GT(std::abs(signed_volume(mesh, 0)), 1);
  if (signed_volume(mesh, 0) < 0) std::swap(mesh.cells(2, 0), mesh.cells(3, 0));
  EXPECT_NEAR(shape_quality(mesh)[0], 1, 1e-14);
  EXPECT_NEAR(size_of_volume<3>(signed_volume(mesh, 0)), std::sqrt(8) * 3,
              1e-13);
}

}  // namespace
}  // namespace ffcontact
