// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/sparse_lu.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ffcontact/base/single.hpp"
#include "ffcontact/base/symmetric.hpp"

namespace ffcontact {

/// Order of elimination by A + A', which is symmetric but for frames that turn.
struct MinimumDegree {
  using PermutationType = Eigen::PermutationMatrix<Dynamic, Dynamic, int>;
  template <class Given>
  void operator()(const Given& A, PermutationType& order) const {
    PermutationType inverse;
    Eigen::AMDOrdering<int>()(SparseMatrix(A), inverse);
    order = inverse.inverse();
  }
};

namespace {

bool equals_identity(const SparseMatrix& A) {
  if (A.nonZeros() != A.cols()) return false;
  for (int j = 0; j < A.cols(); ++j)
    if (A.coeff(j, j) != 1) return false;
  return true;
}

/// Right-hand sides that are solved at once, with all of an unknown side by side: as many
/// as fill a line of the cache.
template <class Scalar>
constexpr int together = 64 / sizeof(Scalar);
template <class Scalar>
using Together = Matrix<Scalar, together<Scalar>, Dynamic>;
template <class Scalar>
using OneOfAll = Matrix<Scalar, together<Scalar>, 1>;

template <class Scalar>
struct Entry {
  int row;
  Scalar value;
};

/// A column of L and U above each other, without the unit diagonal of L.
template <class Scalar>
struct FactorColumn {
  std::vector<Entry<Scalar>> upper, lower;
  Scalar diagonal = 0;

  void put(int row, int column, double value) {
    const auto rounded = static_cast<Scalar>(value);
    if (row == column)
      diagonal = rounded;
    else
      (row < column ? upper : lower).push_back({row, rounded});
  }
};

using EigenLu = Eigen::SparseLU<SparseMatrix, MinimumDegree>;

/// L and U / size, with the blocks on U's diagonal that Eigen keeps among the columns of L.
template <class Scalar>
std::vector<FactorColumn<Scalar>> columns_of(const EigenLu& lu, double size) {
  const auto U = lu.matrixU();
  using InL = std::decay_t<decltype(U.m_mapL)>;
  using InU = std::decay_t<decltype(U.m_mapU)>;
  std::vector<FactorColumn<Scalar>> columns(lu.cols());
  for (int j = 0; j < lu.cols(); ++j) {
    const auto put = [&](Index row, double value) {
      const auto i = static_cast<int>(row);
      columns[j].put(i, j, i <= j ? value / size : value);
    };
    for (typename InL::InnerIterator e(U.m_mapL, j); e; ++e)
      put(e.row(), e.value());
    for (typename InU::InnerIterator e(U.m_mapU, j); e; ++e)
      put(e.index(), e.value());
  }
  return columns;
}

/// X - the entries times their rows' unknowns.
template <class Scalar>
OneOfAll<Scalar> without(const std::vector<Entry<Scalar>>& entries,
                         const Together<Scalar>& X, OneOfAll<Scalar> x) {
  for (const Entry<Scalar>& e : entries) x -= e.value * X.col(e.row);
  return x;
}

/// U'^-1, then L'^-1.
template <class Scalar>
void solve_transposed(const std::vector<FactorColumn<Scalar>>& LU,
                      Together<Scalar>& X) {
  const auto n = static_cast<int>(LU.size());
  for (int j = 0; j < n; ++j)
    X.col(j) = without<Scalar>(LU[j].upper, X, X.col(j)) / LU[j].diagonal;
  for (int j = n - 1; j >= 0; --j)
    X.col(j) = without<Scalar>(LU[j].lower, X, X.col(j));
}

/// B' becomes (A / size)'^-1 B', row by row of B.
template <class Scalar, class Rows>
void solve_rows(const std::vector<FactorColumn<Scalar>>& LU, const EigenLu& lu,
                Rows& B) {
  const VectorXi from = lu.colsPermutation().indices(),
                 to = lu.rowsPermutation().indices();
  const Index count = B.rows(), n = B.cols(), at_once = together<Scalar>;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index first = 0; first < count; first += at_once) {
    const Index rows = std::min(at_once, count - first);
    Together<Scalar> X = Together<Scalar>::Zero(at_once, n);
    for (Index i = 0; i < n; ++i)
      X.col(from[i]).head(rows) = B.col(i).segment(first, rows);
    solve_transposed(LU, X);
    for (Index i = 0; i < n; ++i)
      B.col(i).segment(first, rows) = X.col(to[i]).head(rows);
  }
}

/// S becomes (A / size)'^-1 S (A / size)^-1.
template <class Scalar>
void transform(const EigenLu& lu, double size,
               Matrix<Scalar, Dynamic, Dynamic>& S) {
  const auto LU = columns_of<Scalar>(lu, size);
  solve_rows(LU, lu, S);
  S.transposeInPlace();
  solve_rows(LU, lu, S);
  mirror_lower(S);
}

/// factor M, column by column.
template <class Result, class Given>
Result scaled(const Given& M, double factor, Result result) {
  using Scalar = typename Result::Scalar;
  result.resize(M.rows(), M.cols());
#pragma omp parallel for
  for (Index j = 0; j < M.cols(); ++j)
    result.col(j) =
        (factor * M.col(j).template cast<double>()).template cast<Scalar>();
  return result;
}

/// A power of two near the largest value, by which nothing is rounded.
double scale_of(double largest) { return std::exp2(std::ilogb(largest)); }

}  // namespace

struct SparseLu::Factor {
  bool identity;
  double largest;  ///< |A_ij|
  EigenLu lu;
};

SparseLu::SparseLu(SparseMatrix A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  factor_->identity = equals_identity(A);
  factor_->largest = A.coeffs().abs().maxCoeff();
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
  MatrixXd rows = B.transpose();
  solve_rows(columns_of<double>(factor_->lu, 1), factor_->lu, rows);
  return rows.transpose();
}

MatrixXd SparseLu::congruent(MatrixXd S) const {
  if (!factor_->identity) transform(factor_->lu, 1, S);
  return S;
}

MatrixXd SparseLu::congruent_in_single_precision(MatrixXd S) const {
  if (factor_->identity) return S;
  const double a = scale_of(factor_->largest),
               s = scale_of(S.cwiseAbs().maxCoeff());
  auto rough = scaled(S, 1 / s, MatrixXf());
  transform(factor_->lu, a, rough);
  return scaled(rough, s / a / a, std::move(S));
}

}  // namespace ffcontact
