// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/dropping_cholesky.hpp"

#include <cmath>

namespace ffcontact {

namespace {

constexpr double nothing = 1e-6;

}  // namespace

DroppingCholesky::DroppingCholesky(const MatrixXd& A)
    : R_(A.diagonal().unaryExpr(
          [](double entry) { return entry > 0 ? 1 / std::sqrt(entry) : 0; })),
      ldlt_(R_.asDiagonal() * A * R_.asDiagonal()) {}

VectorXf DroppingCholesky::solve(const VectorXf& b) const {
  VectorXd x = ldlt_.transpositionsP() * R_.cwiseProduct(b.cast<double>());
  ldlt_.matrixL().solveInPlace(x);
  const auto pivots = ldlt_.vectorD();
  for (Index k = 0; k < x.size(); ++k)
    x[k] = pivots[k] > nothing ? x[k] / pivots[k] : 0;
  ldlt_.matrixU().solveInPlace(x);
  x = ldlt_.transpositionsP().transpose() * x;
  return R_.cwiseProduct(x).cast<float>();
}

}  // namespace ffcontact
