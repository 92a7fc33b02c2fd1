// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/sparse_lu.hpp"

#include <klu.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/single.hpp"
#include "ffcontact/base/symmetric.hpp"

namespace ffcontact {

struct KluFactors {
  SparseMatrix L, U;
  VectorXi rows, columns;  ///< A(rows, columns) = L U
};

/// SuiteSparse's KLU of the whole matrix as one block, with partial pivoting.
class Klu {
 public:
  explicit Klu(SparseMatrix A) {
    klu_defaults(&common_);
    common_.btf = 0;
    common_.scale = 0;
    common_.tol = 1;
    symbolic_ = klu_analyze(static_cast<int>(A.rows()), A.outerIndexPtr(),
                            A.innerIndexPtr(), &common_);
    numeric_ = klu_factor(A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr(),
                          symbolic_, &common_);
  }
  ~Klu() {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;

  bool is_regular() const { return numeric_ != nullptr; }

  MatrixXd solve(MatrixXd B) {
    klu_solve(symbolic_, numeric_, symbolic_->n, static_cast<int>(B.cols()),
              B.data(), &common_);
    return B;
  }
  VectorXd solve_transposed(VectorXd b) {
    klu_tsolve(symbolic_, numeric_, symbolic_->n, 1, b.data(), &common_);
    return b;
  }

  KluFactors factors() {
    const int n = symbolic_->n;
    KluFactors f{SparseMatrix(n, n), SparseMatrix(n, n), VectorXi(n),
                 VectorXi(n)};
    f.L.resizeNonZeros(numeric_->lnz);
    f.U.resizeNonZeros(numeric_->unz);
    klu_extract(numeric_, symbolic_, f.L.outerIndexPtr(), f.L.innerIndexPtr(),
                f.L.valuePtr(), f.U.outerIndexPtr(), f.U.innerIndexPtr(),
                f.U.valuePtr(), nullptr, nullptr, nullptr, f.rows.data(),
                f.columns.data(), nullptr, nullptr, &common_);
    return f;
  }

 private:
  klu_common common_;
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
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

  void put_upper(int row, int column, double value) {
    if (row == column)
      diagonal = static_cast<Scalar>(value);
    else
      upper.push_back({row, static_cast<Scalar>(value)});
  }
  void put_lower(int row, int column, double value) {
    if (row != column) lower.push_back({row, static_cast<Scalar>(value)});
  }
};

/// The columns of L and U / size.
template <class Scalar>
std::vector<FactorColumn<Scalar>> columns_of(const KluFactors& factors,
                                             double size) {
  std::vector<FactorColumn<Scalar>> columns(factors.L.cols());
  for (int j = 0; j < factors.L.cols(); ++j) {
    for (SparseMatrix::InnerIterator e(factors.U, j); e; ++e)
      columns[j].put_upper(e.row(), j, e.value() / size);
    for (SparseMatrix::InnerIterator e(factors.L, j); e; ++e)
      columns[j].put_lower(e.row(), j, e.value());
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
void solve_rows(const std::vector<FactorColumn<Scalar>>& LU,
                const KluFactors& factors, Rows& B) {
  const VectorXi &from = factors.columns, &to = factors.rows;
  const Index count = B.rows(), n = B.cols(), at_once = together<Scalar>;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index first = 0; first < count; first += at_once) {
    const Index rows = std::min(at_once, count - first);
    Together<Scalar> X = Together<Scalar>::Zero(at_once, n);
    for (Index i = 0; i < n; ++i)
      X.col(i).head(rows) = B.col(from[i]).segment(first, rows);
    solve_transposed(LU, X);
    for (Index i = 0; i < n; ++i)
      B.col(to[i]).segment(first, rows) = X.col(i).head(rows);
  }
}

/// S becomes (A / size)'^-1 S (A / size)^-1.
template <class Scalar>
void transform(const KluFactors& factors, double size,
               Matrix<Scalar, Dynamic, Dynamic>& S) {
  const auto LU = columns_of<Scalar>(factors, size);
  solve_rows(LU, factors, S);
  S.transposeInPlace();
  solve_rows(LU, factors, S);
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
  double largest;          ///< |A_ij|
  std::optional<Klu> klu;  ///< but of the identity
};

SparseLu::SparseLu(SparseMatrix A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  factor_->largest = A.coeffs().abs().maxCoeff();
  if (!equals_identity(A)) factor_->klu.emplace(std::move(A));
}

SparseLu::~SparseLu() = default;

SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_regular() const {
  return is_identity() || factor_->klu->is_regular();
}

bool SparseLu::is_identity() const { return !factor_->klu; }

VectorXd SparseLu::solve(const VectorXd& b) const { return solve_columns(b); }

MatrixXd SparseLu::solve_columns(const MatrixXd& B) const {
  return is_identity() ? B : factor_->klu->solve(B);
}

VectorXd SparseLu::solve_transposed(const VectorXd& b) const {
  return is_identity() ? b : factor_->klu->solve_transposed(b);
}

MatrixXd SparseLu::solve_transposed_columns(const MatrixXd& B) const {
  if (is_identity()) return B;
  const KluFactors factors = factor_->klu->factors();
  MatrixXd rows = B.transpose();
  solve_rows(columns_of<double>(factors, 1), factors, rows);
  return rows.transpose();
}

MatrixXd SparseLu::congruent(MatrixXd S) const {
  if (!is_identity()) transform(factor_->klu->factors(), 1, S);
  return S;
}

MatrixXd SparseLu::congruent_in_single_precision(MatrixXd S) const {
  if (is_identity()) return S;
  const double a = scale_of(factor_->largest), s = scale_of(max_norm(S));
  auto rough = scaled(S, 1 / s, MatrixXf());
  transform(factor_->klu->factors(), a, rough);
  return scaled(rough, s / a / a, std::move(S));
}

}  // namespace ffcontact
