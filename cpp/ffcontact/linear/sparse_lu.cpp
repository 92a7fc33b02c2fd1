// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/sparse_lu.hpp"

#include <klu.h>

#include <optional>
#include <utility>

#include "ffcontact/linear/dense/symmetric.hpp"

namespace ffcontact {

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
  MatrixXd solve_transposed(MatrixXd B) {
    klu_tsolve(symbolic_, numeric_, symbolic_->n, static_cast<int>(B.cols()),
               B.data(), &common_);
    return B;
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

}  // namespace

struct SparseLu::Factor {
  std::optional<Klu> klu;  ///< but of the identity
};

SparseLu::SparseLu(SparseMatrix A) : factor_(std::make_unique<Factor>()) {
  A.makeCompressed();
  if (!equals_identity(A)) factor_->klu.emplace(std::move(A));
}

SparseLu::~SparseLu() = default;

SparseLu::SparseLu(SparseLu&&) noexcept = default;

bool SparseLu::is_regular() const {
  return is_identity() || factor_->klu->is_regular();
}

bool SparseLu::is_identity() const { return !factor_->klu; }

VectorXd SparseLu::solve(const VectorXd& b) const { return solve_columns(b); }

MatrixXd SparseLu::solve_columns(MatrixXd B) const {
  if (is_identity()) return B;
  return factor_->klu->solve(std::move(B));
}

VectorXd SparseLu::solve_transposed(const VectorXd& b) const {
  return solve_transposed_columns(b);
}

MatrixXd SparseLu::solve_transposed_columns(MatrixXd B) const {
  if (is_identity()) return B;
  return factor_->klu->solve_transposed(std::move(B));
}

MatrixXd SparseLu::congruent(MatrixXd S) const {
  if (is_identity()) return S;
  S = solve_transposed_columns(std::move(S));
  S.transposeInPlace();
  S = solve_transposed_columns(std::move(S));
  mirror_lower(S);
  return S;
}

}  // namespace ffcontact
