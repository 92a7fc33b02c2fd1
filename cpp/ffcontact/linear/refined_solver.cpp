// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/refined_solver.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr float least_condition = 1e-5F;
constexpr int most_refinements = 10;
/// What a step gains at least with the factors of another system.
constexpr double gain_of_other_factors = 4;

/// Of a right-hand side of any size, as single numbers may not have it.
VectorXd solved(const LapackLu<float>& lu, const VectorXd& right) {
  const double scale = max_norm(right);
  if (scale == 0) return right;
  return scale *
         lu.solve_transposed((right / scale).cast<float>()).cast<double>();
}

/// Nothing where a step gains too little.
std::optional<VectorXd> refined(const LapackLu<float>& lu,
                                const MatrixXd& transposed, const VectorXd& b,
                                double least_gain) {
  const double norm = transposed.cwiseAbs().colwise().sum().maxCoeff(),
               rounding = std::sqrt(static_cast<double>(b.size())) *
                          std::numeric_limits<double>::epsilon() * norm;
  VectorXd x = solved(lu, b);
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_refinements; ++step) {
    const VectorXd residual = b - transposed.transpose() * x;
    const double size = max_norm(residual);
    x += solved(lu, residual);
    if (size <= rounding * max_norm(x)) return x;
    if (!(size * least_gain <= last)) return std::nullopt;
    last = size;
  }
  return std::nullopt;
}

}  // namespace

std::optional<VectorXd> RefinedSolver::solve_transposed(
    const MatrixXd& transposed, const VectorXd& b) {
  assert(transposed.rows() == transposed.cols() && transposed.rows() > 0);
  if (lu_ && lu_->size() == transposed.rows())
    if (std::optional<VectorXd> x =
            refined(*lu_, transposed, b, gain_of_other_factors))
      return x;
  lu_.emplace(transposed.cast<float>());
  if (lu_->reciprocal_condition() > least_condition)
    return refined(*lu_, transposed, b, 0);
  lu_.reset();
  return std::nullopt;
}

}  // namespace ffcontact
