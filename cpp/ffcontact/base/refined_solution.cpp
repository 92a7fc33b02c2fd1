// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/refined_solution.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "ffcontact/base/dense_lu.hpp"
#include "ffcontact/base/norms.hpp"

namespace ffcontact {

namespace {

constexpr float least_condition = 1e-5F;
constexpr int most_refinements = 10;

/// Of a right-hand side of any size, as single numbers may not have it.
VectorXd solved(const LapackLu<float>& lu, const VectorXd& right) {
  const double scale = max_norm(right);
  if (scale == 0) return right;
  return scale * lu.solve((right / scale).cast<float>()).cast<double>();
}

}  // namespace

std::optional<VectorXd> refined_solution(const MatrixXd& A, const VectorXd& b) {
  assert(A.rows() == A.cols() && A.rows() > 0);
  const LapackLu<float> lu(A.cast<float>());
  if (!(lu.reciprocal_condition() > least_condition)) return std::nullopt;
  const double norm = A.cwiseAbs().rowwise().sum().maxCoeff(),
               rounding = std::sqrt(static_cast<double>(A.rows())) *
                          std::numeric_limits<double>::epsilon();
  VectorXd x = solved(lu, b);
  for (int step = 0; step < most_refinements; ++step) {
    const VectorXd residual = b - A * x;
    if (max_norm(residual) <= rounding * norm * max_norm(x)) return x;
    x += solved(lu, residual);
  }
  return std::nullopt;
}

}  // namespace ffcontact
