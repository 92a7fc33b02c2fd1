// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/sparse_lu.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <vector>

#include "ffcontact/base/symmetric.hpp"

namespace ffcontact {

namespace {

bool equals_identity(const SparseMatrix& A) {
  if (A.nonZeros() != A.cols()) return false;
  for (int j = 0; j < A.cols(); ++j)
    if (A.coeff(j, j) != 1) return false;
  return true;
}

/// Right-hand sides that are solved at once, with all of an unknown side by side.
constexpr int together = 8;
using Together = Matrix<double, together, Dynamic>;
using OneOfAll = Matrix<double, together, 1>;

struct Entry {
  int row;
  double value;
};

/// A column of L and U above each other, without the unit diagonal of L.
struct FactorColumn {
  std::vector<Entry> upper, lower;
  double diagonal = 0;

  void put(int row, int column, double value) {
    if (row == column)
      diagonal = value;
    else
      (row < column ? upper : lower).push_back({row, value});
  }
};

using EigenLu = Eigen::SparseLU<SparseMatrix>;

/// Eigen keeps the blocks on U's diagonal among the columns of L.
std::vector<FactorColumn> columns_of(const EigenLu& lu) {
  const auto U = lu.matrixU();
  using InL = std::decay_t<decltype(U.m_mapL)>;
  using InU = std::decay_t<decltype(U.m_mapU)>;
  std::vector<FactorColumn> columns(lu.cols());
  for (int j = 0; j < lu.cols(); ++j) {
    for (typename InL::InnerIterator e(U.m_mapL, j); e; ++e)
      columns[j].put(static_cast<int>(e.row()), j, e.value());
    for (typename InU::InnerIterator e(U.m_mapU, j); e; ++e)
      columns[j].put(static_cast<int>(e.index()), j, e.value());
  }
  return columns;
}

/// X - the entries times their rows' unknowns.
OneOfAll without(const std::vector<Entry>& entries, const Together& X,
                 OneOfAll x) {
  for (const Entry& e : entries) x -= e.value * X.col(e.row);
  return x;
}

/// U'^-1, then L'^-1.
void solve_transposed(const std::vector<FactorColumn>& LU, Together& X) {
  const auto n = static_cast<int>(LU.size());
  for (int j = 0; j < n; ++j)
    X.col(j) = without(LU[j].upper, X, X.col(j)) / LU[j].diagonal;
  for (int j = n - 1; j >= 0; --j) X.col(j) = without(LU[j].lower, X, X.col(j));
}

/// The transposed A'^-1 B', row by row of B.
MatrixXd solved_rows(const EigenLu& lu, const MatrixXd& B) {
  const std::vector<FactorColumn> LU = columns_of(lu);
  const VectorXi from = lu.colsPermutation().indices(),
                 to = lu.rowsPermutation().indices();
  MatrixXd result(B.rows(), B.cols());
  const Index count = B.rows(), n = B.cols();
#pragma omp parallel for schedule(dynamic, 1)
  for (Index first = 0; first < count; first += together) {
    const Index rows = std::min<Index>(together, count - first);
    Together X = Together::Zero(together, n);
    for (Index i = 0; i < n; ++i)
      X.col(from[i]).head(rows) = B.col(i).segment(first, rows);
    solve_transposed(LU, X);
    for (Index i = 0; i < n; ++i)
      result.col(i).segment(first, rows) = X.col(to[i]).head(rows);
  }
  return result;
}

}  // namespace

struct SparseLu::Factor {
  bool identity;
  EigenLu lu;
};

SparseLu::SparseLu(SparseMatrix A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  factor_->identity = equals_identity(A);
  if (!factor_->identity) factor_->lu.compute(A);
}

SparseLu::~SparseLu() = default;

SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_regular() const {
  return factor_->identity || factor_->lu.info() == Eigen::Success;
}

bool SparseLu::is_identity() const { return factor_->identity; }

VectorXd SparseLu::solve(const VectorXd& b) const {
  return factor_->identity ? b : VectorXd(factor_->lu.solve(b));
}

VectorXd SparseLu::solve_transposed(const VectorXd& b) const {
  return factor_->identity ? b : VectorXd(factor_->lu.transpose().solve(b));
}

// Eigen's SparseLU does not take zero columns.
MatrixXd SparseLu::solve_columns(const MatrixXd& B) const {
  if (B.cols() == 0 || factor_->identity) return B;
  return factor_->lu.solve(B);
}

MatrixXd SparseLu::solve_transposed_columns(const MatrixXd& B) const {
  if (B.cols() == 0 || factor_->identity) return B;
  return solved_rows(factor_->lu, B.transpose()).transpose();
}

MatrixXd SparseLu::congruent(const MatrixXd& S) const {
  if (factor_->identity) return S;
  MatrixXd half = solved_rows(factor_->lu, S);  // S A^-1
  half.transposeInPlace();
  MatrixXd result = solved_rows(factor_->lu, half);
  mirror_lower(result);
  return result;
}

}  // namespace ffcontact
