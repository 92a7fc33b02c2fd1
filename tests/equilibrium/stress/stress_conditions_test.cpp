// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"

#include <gtest/gtest.h>

#include "support/cells.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Columns: a linear function of the coefficients for each of them.
template <int d, class Function>
MatrixXd matrix_of(const Function& function) {
  using Stress = SubcellStress<d>;
  MatrixXd result(function(Stress::Zero()).size(), Stress::SizeAtCompileTime);
  for (int unit = 0; unit < result.cols(); ++unit) {
    Stress stress = Stress::Zero();
    stress.reshaped()[unit] = 1;
    result.col(unit) = function(stress).reshaped();
  }
  return result;
}

MatrixXd stacked(const MatrixXd& above, const MatrixXd& below) {
  MatrixXd result(above.rows() + below.rows(), above.cols());
  result << above, below;
  return result;
}

Index kernel(const MatrixXd& conditions) {
  Eigen::FullPivLU<MatrixXd> lu(conditions);
  lu.setThreshold(1e-10);
  return lu.dimensionOfKernel();
}

/// Dimensions of stresses with continuous tractions, without divergence, without outer
/// tractions, and without these and with one divergence.
template <int d>
std::array<Index, 4> dimensions(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  using Stress = SubcellStress<d>;
  const MatrixXd jumps = matrix_of<d>(
                     [&](const Stress&s) { return inner_jumps<d>(x, s); }),
                 divergence = matrix_of<d>(
                     [&](const Stress&s) { return divergences<d>(x, s); }),
                 loads = matrix_of<d>(
                     [&](const Stress&s) { return facet_loads_of<d>(x, s); });
  MatrixXd differences = divergence.bottomRows(d * d);
  for (int k = 0; k < d; ++k)
    differences.middleRows(d * k, d) -= divergence.topRows(d);
  return {kernel(jumps), kernel(stacked(jumps, divergence)),
          kernel(stacked(jumps, loads)),
          kernel(stacked(stacked(jumps, loads), differences))};
}

RC_GTEST_PROP(StressConditions, leave_the_dimensions_of_the_theory,
              (Random random)) {
  // loads less balance, and as many body forces as subcells; what has no tractions is
  // balanced in itself
  RC_ASSERT((dimensions<2>(random) == std::array<Index, 4>{15, 9, 3, 0}));
  RC_ASSERT((dimensions<3>(random) == std::array<Index, 4>{42, 30, 6, 0}));
}

template <int d>
double spoilt_defect(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  const LinearStress<d> linear(random);
  const Loads<d> loads = linear.loads(x);
  SubcellStress<d> stress = linear.values(x);
  stress.reshaped()[random() % stress.size()] += 1e-4;
  return cell_defect<d>(x, stress, loads.on_facets, loads.in_body).largest();
}

RC_GTEST_PROP(StressConditions, see_every_spoilt_number, (Random random)) {
  RC_ASSERT(spoilt_defect<2>(random) > 1e-7);
  RC_ASSERT(spoilt_defect<3>(random) > 1e-7);
}

/// Largest difference between int f phi_i and the body loads that f was made from.
template <int d>
double moment_error(Random& random) {
  const CellBodyLoads<d> loads = random_matrix(d, d + 1, random);
  constexpr double n = d + 1, volume = 2;
  const CellBodyLoads<d> f = body_force_of<d>(loads, volume);
  // phi_i has the mean 1/n^2 over subcell i and (n + 1)/n^2 over the others
  const VectorOf<d> sum = f.rowwise().sum();
  CellBodyLoads<d> moments = -n * f;
  moments.colwise() += (n + 1) * sum;
  return (volume / (n * n * n) * moments - loads).norm();
}

RC_GTEST_PROP(StressConditions, body_force_has_its_moments, (Random random)) {
  RC_ASSERT(moment_error<2>(random) < 1e-13);
  RC_ASSERT(moment_error<3>(random) < 1e-13);
}

/// Of the equations for the values of a linear stress and its loads.
template <int d>
double residual(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  const LinearStress<d> linear(random);
  const Loads<d> loads = linear.loads(x);
  VectorXd all(loads.on_facets.size() + loads.in_body.size());
  all << loads.on_facets.reshaped(), loads.in_body.reshaped();
  const StressConditions<d> conditions(x);
  return (conditions.matrix * linear.values(x).reshaped() -
          conditions.right * all)
      .norm();
}

RC_GTEST_PROP(StressConditions, hold_for_linear_stresses, (Random random)) {
  RC_ASSERT(residual<2>(random) < 1e-12);
  RC_ASSERT(residual<3>(random) < 1e-12);
}

template <int d>
double density_error(Random& random) {
  const double measure = *real(0.01, 100);
  const MatrixOf<d> density = random_matrix(d, d, random);
  const MatrixOf<d> moments = facet_moments_of<d>(density, measure);
  const double force =
      (moments.rowwise().sum() - measure * density.rowwise().mean()).norm();
  return (facet_density<d>(moments, measure) - density).norm() +
         force / measure;
}

RC_GTEST_PROP(FacetDensity, and_moments_are_inverse_to_each_other,
              (Random random)) {
  RC_ASSERT(density_error<2>(random) < 1e-13);
  RC_ASSERT(density_error<3>(random) < 1e-13);
}

TEST(FacetDensity, a_constant_one_has_half_its_resultant_at_each_end) {
  Matrix2d density;
  density << 3, 3, -1, -1;
  EXPECT_EQ(facet_moments_of<2>(density, 4), 2 * density);
}

}  // namespace
}  // namespace ffcontact
