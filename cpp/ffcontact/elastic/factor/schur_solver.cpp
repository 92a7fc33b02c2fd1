// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/schur_solver.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/symmetric_product.hpp"
#include "ffcontact/linear/iterative/aggregates.hpp"
#include "ffcontact/linear/iterative/conjugate_gradients.hpp"

namespace ffcontact {

namespace {

/// What the rounding of the factor leaves is larger.
constexpr double tolerance = 1e-5;

/// The vertices of the kept dofs, numbered as they come.
struct KeptVertices {
  std::map<int, int> number;
  std::vector<int> of_dof;  ///< [kept]

  KeptVertices(const ElasticSystem& system, const std::vector<int>& kept) {
    for (int dof : kept)
      of_dof.push_back(number.emplace(dof / system.dimension, count_of(number))
                           .first->second);
  }
};

/// Those that K couples.
SparseMatrix neighbours(const ElasticSystem& system,
                        const std::vector<int>& kept,
                        const KeptVertices& vertices) {
  Triplets pairs;
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (RowMatrix::InnerIterator e(system.stiffness, kept[k]); e; ++e) {
      const auto other =
          vertices.number.find(static_cast<int>(e.col()) / system.dimension);
      if (other != vertices.number.end())
        pairs.emplace_back(other->second, vertices.of_dof[k], 1);
    }
  const int count = count_of(vertices.number);
  return packed(count, count, pairs);
}

/// R = 1 from an aggregate of neighbouring vertices to the kept dofs of these, one column a
/// component [kept x components of aggregates].
SparseMatrix aggregated_motions(const ElasticSystem& system,
                                const std::vector<int>& kept) {
  const KeptVertices vertices(system, kept);
  const Aggregates gathered = aggregates(neighbours(system, kept, vertices));
  std::map<std::pair<int, int>, int> column;  // where a dof is kept
  Triplets entries;
  for (int k = 0; k < count_of(kept); ++k) {
    const std::pair<int, int> component{gathered.of_node[vertices.of_dof[k]],
                                        kept[k] % system.dimension};
    entries.emplace_back(
        k, column.emplace(component, count_of(column)).first->second, 1);
  }
  return packed(count_of(kept), count_of(column), entries);
}

}  // namespace

struct SchurSolver::TwoLevels {
  VectorXd inverse_diagonal;
  SparseMatrix R;
  DenseCholesky coarse;

  TwoLevels(const MatrixXd& S, const MatrixXd& motions, SparseMatrix prolonged)
      : inverse_diagonal(
            (S.diagonal() + motions.rowwise().squaredNorm()).cwiseInverse()),
        R(std::move(prolonged)),
        coarse(coarse_matrix(S, motions)) {}

  MatrixXd coarse_matrix(const MatrixXd& S, const MatrixXd& motions) const {
    const MatrixXd Z = R.transpose() * motions;
    MatrixXd matrix = congruent(S, R);
    add_square(Z, matrix);
    return matrix;
  }

  VectorXd operator()(const VectorXd& r) const {
    return inverse_diagonal.cwiseProduct(r) +
           R * coarse.solve(R.transpose() * r);
  }
};

SchurSolver::SchurSolver(const ElasticSystem& system,
                         const std::vector<int>& kept,
                         const CondensedStiffness& stiffness,
                         const MatrixXd& motions, int most_steps)
    : S_(stiffness.schur()), most_steps_(most_steps), motions_(motions) {
  if (motions.cols() > 0)
    motions_ *= std::sqrt(S_.diagonal().mean() /
                          motions.colwise().squaredNorm().mean());
  if (stiffness.is_exact()) return;
  auto two_levels = std::make_unique<const TwoLevels>(
      S_, motions_, aggregated_motions(system, kept));
  if (two_levels->coarse.is_positive_definite())
    preconditioner_ = std::move(two_levels);
}

SchurSolver::~SchurSolver() = default;

VectorXd SchurSolver::solve(const VectorXd& g) const {
  if (preconditioner_ && direct_.size() == 0) {
    const auto product = [&](const VectorXd& x) -> VectorXd {
      const VectorXd along = motions_.transpose() * x;
      return symmetric_product(S_, x) + motions_ * along;
    };
    const auto x = conjugate_gradients(product, *preconditioner_, g,
                                       {tolerance, most_steps_});
    if (x) return *x;
  }
  if (direct_.size() == 0) direct_ = DenseCholesky(regular_matrix());
  return direct_.solve(g);
}

MatrixXd SchurSolver::regular_matrix() const {
  MatrixXd regular = S_;
  add_square(motions_, regular);
  return regular;
}

}  // namespace ffcontact
