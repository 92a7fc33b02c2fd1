// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/matrix_free/product_relation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/contact/newton/coarse_start.hpp"
#include "ffcontact/elastic/factor/schur_solver.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/linear/selected_rows.hpp"

namespace ffcontact {

namespace {

constexpr int dimension = 3;

/// [1 -A_o; 0 1]
SparseMatrix from_unknowns(const SparseMatrix& A_primary) {
  const Index f = A_primary.rows(), n = A_primary.cols();
  Triplets entries;
  for (int j = 0; j < n; ++j) {
    entries.emplace_back(j, j, 1);
    for (SparseMatrix::InnerIterator e(A_primary, j); e; ++e) {
      if (j >= f) entries.emplace_back(e.row(), j, -e.value());
    }
  }
  return packed(n, n, entries);
}

/// Of each component the vertex that it moves.
std::vector<int> moved_vertices(const SparseMatrix& to_kept,
                                const std::vector<int>& kept) {
  std::vector<int> vertex;
  for (int k = 0; k < to_kept.cols(); ++k)
    vertex.push_back(kept[SparseMatrix::InnerIterator(to_kept, k).row()] /
                     dimension);
  return vertex;
}

std::vector<int> vertices_of(const std::vector<int>& dofs) {
  std::vector<int> vertex;
  for (int dof : dofs) vertex.push_back(dof / dimension);
  return vertex;
}

/// What is between unknowns of one vertex.
SparseMatrix within_vertices(SparseMatrix M, const std::vector<int>& vertex) {
  M.prune([&vertex](Index row, Index column, double) {
    return vertex[row] == vertex[column];
  });
  return M;
}

/// (D' D)^-1 D' of to_kept = D, vertex by vertex: components of displacements.
SparseMatrix to_components(const SparseMatrix& to_kept,
                           const std::vector<int>& vertex) {
  std::map<int, std::vector<int>> of_vertex;
  for (int k = 0; k < count_of(vertex); ++k) of_vertex[vertex[k]].push_back(k);
  const SparseMatrix gram =
      within_vertices(SparseMatrix(to_kept.transpose() * to_kept), vertex);
  Triplets entries;
  for (const auto& [v, own] : of_vertex) {
    MatrixXd G(own.size(), own.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t j = 0; j < own.size(); ++j)
        G(i, j) = gram.coeff(own[i], own[j]);
    const MatrixXd inverse =
        G.llt().solve(MatrixXd::Identity(G.rows(), G.cols()));
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t j = 0; j < own.size(); ++j)
        entries.emplace_back(own[i], own[j], inverse(i, j));
  }
  return packed(to_kept.cols(), to_kept.cols(), entries) *
         SparseMatrix(to_kept.transpose());
}

/// 1 / (1 / S_kk + sum_j (A_o)_kj^2 / S_jj) [f]
VectorXd series_stiffness(const SparseMatrix& to_kept, const SparseMatrix& S,
                          const SparseMatrix& A_primary) {
  const Index f = A_primary.rows();
  const VectorXd diagonal =
      SparseMatrix(to_kept.transpose() * (S * to_kept)).diagonal();
  VectorXd compliance = diagonal.head(f).cwiseMax(1e-300).cwiseInverse();
  for (Index j = f; j < A_primary.cols(); ++j)
    for (SparseMatrix::InnerIterator e(A_primary, j); e; ++e)
      if (diagonal[j] > 0)
        compliance[e.row()] += e.value() * e.value() / diagonal[j];
  return compliance.cwiseInverse();
}

/// The largest entry on the diagonal at the vertex of each unknown.
VectorXd stiffest_components(const ProductRelation& relation) {
  const VectorXd diagonal = relation.blocks.diagonal();
  std::map<int, double> largest;
  for (Index k = 0; k < diagonal.size(); ++k) {
    double& of_vertex = largest[relation.vertex[k]];
    of_vertex = std::max(of_vertex, diagonal[k]);
  }
  return VectorXd::NullaryExpr(
      diagonal.size(), [&](Index k) { return largest[relation.vertex[k]]; });
}

}  // namespace

int ProductRelation::row(Index k) const {
  const int f = count_of(primary);
  return k < f ? primary[k] : static_cast<int>(position.size() + k) - f;
}

ProductRelation product_relation(
    const SurfaceTrace& trace, const ElasticSystem& system,
    std::shared_ptr<const CondensedStiffness> stiffness) {
  const ContactTrace& moved = trace.trace;
  CondensedContact numbered;
  number_rows(trace.primary, static_cast<int>(moved.A.rows()), numbered);
  ProductRelation relation;
  relation.stiffness = std::move(stiffness);
  relation.S = relation.stiffness->products();
  relation.primary = std::move(numbered.primary);
  relation.dependent = std::move(numbered.dependent);
  relation.position = std::move(numbered.position);
  const SparseMatrix A = selected_rows(moved.A, relation.primary),
                     M = from_unknowns(A);
  relation.T = moved.to_kept * M;
  relation.E = (selected_rows(moved.A, relation.dependent) * M).transpose();
  const std::vector<int>& kept = moved.kept_dofs;
  relation.vertex = moved_vertices(moved.to_kept, kept);
  const SparseMatrix S = relation.S->diagonal_blocks(vertices_of(kept));
  relation.blocks = within_vertices(
      SparseMatrix(relation.T.transpose() * (S * relation.T)), relation.vertex);
  relation.row_stiffness = series_stiffness(moved.to_kept, S, A);
  relation.motions = to_components(moved.to_kept, relation.vertex) *
                     aggregated_motions(system, kept);
  put_loads(system.load, moved.v_prescribed, relation);
  return relation;
}

void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
               ProductRelation& relation) {
  relation.load = relation.stiffness->condensed(load);
  relation.given = VectorXd::Zero(relation.size());
  relation.given.head(count_of(relation.primary)) =
      v_prescribed(relation.primary);
  relation.g = relation.T.transpose() * relation.load.on_kept +
               product(relation, relation.given);
  relation.dependent_offset = v_prescribed(relation.dependent) -
                              relation.E.transpose() * relation.given;
}

VectorXd product(const ProductRelation& relation, const VectorXd& x) {
  return relation.T.transpose() * relation.S->product(relation.T * x);
}

ContactRows change_of_rows(const ProductRelation& relation, const VectorXd& x,
                           const VectorXd& q) {
  const VectorXd P = product(relation, x) - relation.E * q;
  ContactRows rows{VectorXd::Zero(relation.row_count()),
                   VectorXd::Zero(relation.row_count())};
  for (Index k = 0; k < relation.size(); ++k) {
    rows.P[relation.row(k)] = P[k];
    rows.v[relation.row(k)] = x[k];
  }
  rows.P(relation.dependent) = q;
  rows.v(relation.dependent) = relation.E.transpose() * x;
  return rows;
}

ContactRows rows_of(const ProductRelation& relation, const VectorXd& x,
                    const VectorXd& q) {
  ContactRows rows = change_of_rows(relation, x, q);
  for (Index k = 0; k < relation.size(); ++k)
    rows.P[relation.row(k)] -= relation.g[k];
  rows.v(relation.dependent) += relation.dependent_offset;
  return rows;
}

LawScales law_scales(const ProductRelation& relation, const VectorXd& v) {
  constexpr double share_of_loads = 1e-4;
  const VectorXd stiffest = stiffest_components(relation);
  double motion = max_norm(v);
  for (Index k = 0; k < stiffest.size(); ++k)
    if (stiffest[k] > 0)
      motion = std::max(motion, std::abs(relation.g[k]) / stiffest[k]);
  return {motion, share_of_loads * max_norm(relation.g)};
}

VectorXd kept_displacement(const ProductRelation& relation,
                           const ContactRows& rows) {
  const VectorXd x = VectorXd::NullaryExpr(
      relation.size(), [&](Index k) { return rows.v[relation.row(k)]; });
  return relation.T * (x - relation.given);
}

CoarseRelation coarse_relation(const ProductRelation& relation,
                               const SparseMatrix& Q) {
  const Index f = Q.rows(), own = Q.cols(), n = relation.size();
  Triplets entries;
  for (int j = 0; j < own; ++j)
    for (SparseMatrix::InnerIterator e(Q, j); e; ++e)
      entries.emplace_back(e.row(), j, e.value());
  Index columns = own;
  for (int j = 0; j < relation.motions.cols(); ++j) {
    bool opposite = false;
    for (SparseMatrix::InnerIterator e(relation.motions, j); e; ++e)
      if (e.row() >= f) {
        entries.emplace_back(e.row(), columns, e.value());
        opposite = true;
      }
    columns += opposite;
  }
  const SparseMatrix R = packed(n, columns, entries);
  MatrixXd S = relation.S->congruent(relation.T * R);
  VectorXd g = R.transpose() * relation.g;
  const Index o = columns - own;
  if (o == 0) return {std::move(S), std::move(g)};
  const Eigen::LDLT<MatrixXd> opposite(S.bottomRightCorner(o, o));
  const MatrixXd X = opposite.solve(S.bottomLeftCorner(o, own));
  return {S.topLeftCorner(own, own) - S.topRightCorner(own, o) * X,
          g.head(own) - X.transpose() * g.tail(o)};
}

}  // namespace ffcontact
