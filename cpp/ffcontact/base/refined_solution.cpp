// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/refined_solution.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "ffcontact/base/norms.hpp"

extern "C" {
void sgetrf_(const int* rows, const int* columns, float* a, const int* stride,
             int* pivots, int* info);
void sgecon_(const char* norm, const int* n, const float* lu, const int* stride,
             const float* norm_of_a, float* rcond, float* work, int* iwork,
             int* info);
void sgetrs_(const char* transpose, const int* n, const int* columns,
             const float* lu, const int* stride, const int* pivots, float* b,
             const int* stride_of_b, int* info);
}

namespace ffcontact {

namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr float least_condition = 1e-5F;
constexpr int most_refinements = 10;

/// As DenseLu.
class SingleLu {
 public:
  explicit SingleLu(MatrixXf matrix)
      : factors_(std::move(matrix)),
        pivots_(factors_.rows()),
        norm_(factors_.cwiseAbs().colwise().sum().maxCoeff()) {
    const int n = size();
    int info = 0;  // a zero pivot shows in the condition number
    sgetrf_(&n, &n, factors_.data(), &n, pivots_.data(), &info);
  }

  float reciprocal_condition() const {
    const int n = size();
    VectorXf work(4 * n);
    VectorXi integer_work(n);
    float result = 0;
    int info = 0;
    sgecon_("1", &n, factors_.data(), &n, &norm_, &result, work.data(),
            integer_work.data(), &info);
    return info == 0 && std::isfinite(norm_) ? result : 0;
  }

  /// Of a right-hand side of any size, as single numbers may not have it.
  VectorXd solve(const VectorXd& right) const {
    const double scale = max_norm(right);
    if (scale == 0) return right;
    VectorXf x = (right / scale).cast<float>();
    const int n = size(), one = 1;
    int info = 0;
    sgetrs_("N", &n, &one, factors_.data(), &n, pivots_.data(), x.data(), &n,
            &info);
    return scale * x.cast<double>();
  }

 private:
  int size() const { return static_cast<int>(factors_.rows()); }

  MatrixXf factors_;
  VectorXi pivots_;
  float norm_;
};

}  // namespace

std::optional<VectorXd> refined_solution(const MatrixXd& A, const VectorXd& b) {
  assert(A.rows() == A.cols() && A.rows() > 0);
  const SingleLu lu(A.cast<float>());
  if (!(lu.reciprocal_condition() > least_condition)) return std::nullopt;
  const double norm = A.cwiseAbs().rowwise().sum().maxCoeff(),
               rounding = std::sqrt(static_cast<double>(A.rows())) *
                          std::numeric_limits<double>::epsilon();
  VectorXd x = lu.solve(b);
  for (int step = 0; step < most_refinements; ++step) {
    const VectorXd residual = b - A * x;
    if (max_norm(residual) <= rounding * norm * max_norm(x)) return x;
    x += lu.solve(residual);
  }
  return std::nullopt;
}

}  // namespace ffcontact
