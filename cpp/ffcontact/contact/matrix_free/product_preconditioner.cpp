// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/matrix_free/product_preconditioner.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <cmath>
#include <map>

#include "ffcontact/linear/selected_rows.hpp"

namespace ffcontact {

namespace {

/// Share of D, so that T = I - D is regular.
constexpr double nearly_all_of_D = 0.9999;
/// Added to the diagonal of R' H R, relative: columns of R may depend on each other where
/// some components are known.
constexpr double coarse_shift = 1e-8;

/// Rows and columns of a square matrix.
SparseMatrix selected(const SparseMatrix& M, const std::vector<int>& which) {
  const SparseMatrix rows = selected_rows(M, which);
  return SparseMatrix(
      selected_rows(SparseMatrix(rows.transpose()), which).transpose());
}

/// Without its columns of zeros, and what turned axes leave of them.
SparseMatrix without_empty_columns(SparseMatrix M) {
  constexpr double nothing = 1e-9;
  M.prune([](Index, Index, double value) { return std::abs(value) > nothing; });
  Triplets entries;
  Index columns = 0;
  for (int j = 0; j < M.cols(); ++j) {
    bool any = false;
    for (SparseMatrix::InnerIterator e(M, j); e; ++e) {
      entries.emplace_back(e.row(), columns, e.value());
      any = true;
    }
    columns += any;
  }
  return packed(M.rows(), columns, entries);
}

/// The inverse of a matrix of small blocks.
/// @param group  of each row
SparseMatrix inverse_blocks(const SparseMatrix& M,
                            const std::vector<int>& group) {
  std::map<int, std::vector<int>> members;
  for (int k = 0; k < count_of(group); ++k) members[group[k]].push_back(k);
  Triplets entries;
  for (const auto& [of_group, own] : members) {
    const int n = count_of(own);
    MatrixXd block(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) block(i, j) = M.coeff(own[i], own[j]);
    const Eigen::LLT<MatrixXd> factor(block);
    const bool regular = factor.info() == Eigen::Success;
    const MatrixXd inverse =
        regular ? MatrixXd(factor.solve(MatrixXd::Identity(n, n)))
                : MatrixXd(block.diagonal()
                               .cwiseMax(1e-300)
                               .cwiseInverse()
                               .asDiagonal());
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        entries.emplace_back(own[i], own[j], inverse(i, j));
  }
  return packed(M.rows(), M.cols(), entries);
}

}  // namespace

ProductPreconditioner::ProductPreconditioner(const ProductEquations& equations,
                                             double springs)
    : equations_(equations) {
  put_turned();
  put_levels(springs);
  put_dependent();
}

/// T^-1 and T^-1 c D of the tangential unknowns of a node.
void ProductPreconditioner::put_turned() {
  const ProductRelation& relation = equations_.relation;
  const SurfaceEquations& law = equations_.law;
  std::vector<int> number(relation.row_count(), -1);
  for (int e = 0; e < unknowns(); ++e)
    number[relation.row(equations_.unknown[e])] = e;
  Triplets turned, added;
  for (int e = 0; e < unknowns(); ++e) {
    const int row = relation.row(equations_.unknown[e]), node = row / 3;
    if (row >= relation.position.size() || row % 3 == 0) {
      turned.emplace_back(e, e, 1);
      continue;
    }
    const Matrix2d T =
        Matrix2d::Identity() - nearly_all_of_D * law.derivative(node);
    const Matrix2d inverse = T.inverse();
    for (int c = 1; c < 3; ++c)
      if (const int other = number[3 * node + c]; other >= 0) {
        const double value = inverse(row % 3 - 1, c - 1);
        turned.emplace_back(e, other, value);
        added.emplace_back(e, other,
                           law.stiffness(node) * (value - (other == e)));
      }
  }
  T_inverse_ = packed(unknowns(), unknowns(), turned);
  added_ = packed(unknowns(), unknowns(), added);
}

void ProductPreconditioner::put_levels(double springs) {
  const ProductRelation& relation = equations_.relation;
  const std::vector<int>& unknown = equations_.unknown;
  SparseMatrix diagonal = selected(relation.blocks, unknown) + added_;
  const VectorXd own = springs * diagonal.diagonal();
  Triplets held;
  std::vector<int> vertex;
  for (int e = 0; e < unknowns(); ++e) {
    held.emplace_back(e, e, own[e]);
    vertex.push_back(relation.vertex[unknown[e]]);
  }
  added_ += packed(unknowns(), unknowns(), held);
  diagonal += packed(unknowns(), unknowns(), held);
  inverse_diagonal_ = inverse_blocks(diagonal, vertex);
  R_ = without_empty_columns(selected_rows(relation.motions, unknown));
  if (R_.cols() == 0) return;
  const SparseMatrix T_u =
      selected_rows(SparseMatrix(relation.T.transpose()), unknown).transpose();
  MatrixXd coarse = relation.S->congruent(SparseMatrix(T_u * R_));
  coarse += MatrixXd(R_.transpose() * added_ * R_);
  coarse.diagonal() *= 1 + coarse_shift;
  coarse_ = DenseCholesky(std::move(coarse));
}

/// M r
VectorXd ProductPreconditioner::approximate(const VectorXd& r) const {
  VectorXd x = inverse_diagonal_ * r;
  if (coarse_.size() > 0 && coarse_.is_positive_definite())
    x += R_ * coarse_.solve(R_.transpose() * r);
  return x;
}

/// B, and C as its value, of the conditions on dependent rows.
MatrixXd ProductPreconditioner::put_conditions() {
  const ProductRelation& relation = equations_.relation;
  const Index n = unknowns(), count = count_of(equations_.dependent);
  std::map<int, int> place, multiplier;  // of rows
  for (int e = 0; e < n; ++e)
    place.emplace(relation.row(equations_.unknown[e]), e);
  for (int d = 0; d < count; ++d)
    multiplier.emplace(relation.dependent[equations_.dependent[d]], d);
  Triplets of_v;
  MatrixXd C = MatrixXd::Zero(count, count);
  const SparseMatrix E_rows = E_.transpose();
  const Rows by_dependent = E_rows;
  for (int d = 0; d < count; ++d)
    for (const Term& term : equations_.equation[n + d].terms) {
      const auto q = multiplier.find(term.row);
      if (q != multiplier.end()) {
        C(d, q->second) += term.P;
        for (Rows::InnerIterator e(by_dependent, q->second); e; ++e)
          of_v.emplace_back(d, e.col(), term.v * e.value());
      } else if (const auto e = place.find(term.row); e != place.end())
        of_v.emplace_back(d, e->second, term.v);
    }
  B_ = packed(count, n, of_v);
  return C;
}

void ProductPreconditioner::put_dependent() {
  const Index count = count_of(equations_.dependent);
  if (count == 0) return;
  const SparseMatrix E_rows(equations_.relation.E.transpose()),
      E = selected_rows(E_rows, equations_.dependent).transpose();
  E_ = selected_rows(E, equations_.unknown);
  MatrixXd C = put_conditions();
  const VectorXd unit = equations_.unit.tail(count),
                 scale = equations_.scale.tail(count);
  C.diagonal() += proximal_share * (unit.cwiseProduct(scale)).cwiseInverse();
  for (int d = 0; d < count; ++d) C.col(d) += B_ * approximate(E_.col(d));
  const MatrixXd scaled = scale.asDiagonal() * C * unit.asDiagonal();
  dependent_inverse_ = unit.asDiagonal() *
                       Eigen::FullPivLU<MatrixXd>(scaled).inverse() *
                       scale.asDiagonal();
}

VectorXd ProductPreconditioner::operator()(const VectorXd& scaled) const {
  const Index n = unknowns(), count = count_of(equations_.dependent);
  const VectorXd r = scaled.cwiseQuotient(equations_.scale);
  VectorXd result(scaled.size());
  const VectorXd forces = T_inverse_ * r.head(n);
  result.head(n) = approximate(forces);
  if (count > 0) {
    const VectorXd q =
        dependent_inverse_ * (r.tail(count) - B_ * result.head(n));
    result.head(n) += approximate(E_ * q);
    result.tail(count) = q;
  }
  return result.cwiseQuotient(equations_.unit);
}

}  // namespace ffcontact
