// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/coarse_start.hpp"

#include <limits>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/iterative/aggregates.hpp"
#include "ffcontact/linear/selected_rows.hpp"

namespace ffcontact {

namespace {

/// Of the law of the aggregates, which is itself but near the nodes'.
constexpr double near_enough = 1e-3;
constexpr int most_systems = 30;
/// Of diag(S), relative: what moves nothing.
constexpr double no_stiffness = 1e-12;

/// diag(M 1)^-1 M R_0 [p x a]
SparseMatrix smoothed(const Aggregates& aggregates, const SparseMatrix& M) {
  const VectorXd inverse = (M * VectorXd::Ones(M.cols())).cwiseInverse();
  Triplets entries;
  for (int k = 0; k < M.cols(); ++k)
    for (SparseMatrix::InnerIterator e(M, k); e; ++e)
      entries.emplace_back(e.row(), aggregates.of_node[k],
                           inverse[e.row()] * e.value());
  return packed(static_cast<int>(M.rows()), aggregates.count(), entries);
}

/// Weights of aggregates as R of vectors, in the frames of nodes and of aggregates
/// [3p x 3a].
SparseMatrix in_frames(const SparseMatrix& weights,
                       const ContactSurface& surface,
                       const std::vector<int>& first) {
  Triplets entries;
  for (int a = 0; a < weights.cols(); ++a) {
    const Matrix3d frame = surface.frame(first[a]);
    for (SparseMatrix::InnerIterator e(weights, a); e; ++e) {
      const auto i = static_cast<int>(e.row());
      const Matrix3d turn = surface.frame(i).transpose() * frame;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          if (std::abs(turn(c, d)) > std::numeric_limits<double>::epsilon())
            entries.emplace_back(3 * i + c, 3 * a + d, e.value() * turn(c, d));
    }
  }
  return packed(3 * static_cast<int>(weights.rows()),
                3 * static_cast<int>(weights.cols()), entries);
}

/// The relation and the law of the aggregates.
class Coarse {
 public:
  Coarse(const NodalLaw& law, const ContactSurface& surface)
      : surface_(surface),
        aggregates_(aggregates(surface.mass)),
        weights_(smoothed(aggregates_, surface.mass)),
        R_(in_frames(weights_, surface, aggregates_.first)) {
    put_law(law);
  }

  std::optional<ContactRows> rows(const CondensedContact& contact) {
    const SparseMatrix Q = selected_rows(R_, contact.primary);
    put_relation(congruent(contact.S, Q), Q.transpose() * contact.g);
    StepSolver solver(coarse_, held_);
    const ContactStates sticking = all_stick(law_.node_count());
    const ActiveSetResult answer =
        surface_newton(coarse_, law_, held_, sticking, solver,
                       {most_systems, near_enough, {}, near_enough});
    if (answer.status != ContactStatus::converged) return std::nullopt;
    return on_nodes({answer.P, answer.v});
  }

 private:
  /// Of v = Q v_a on the primary rows: F_a = S v_a - g.
  void put_relation(const MatrixXd& S, const VectorXd& g) {
    const double least = no_stiffness * S.diagonal().maxCoeff();
    held_.assign(S.rows(), 0);
    std::vector<int> moving;
    for (int row = 0; row < S.rows(); ++row) {
      held_[row] = !(S(row, row) > least);
      if (!held_[row]) moving.push_back(row);
    }
    coarse_.dimension = 3;
    number_rows(moving, static_cast<int>(S.rows()), coarse_);
    coarse_.S = S(coarse_.primary, coarse_.primary);
    coarse_.g = g(coarse_.primary);
    const Index f = coarse_.g.size(), d = count_of(coarse_.dependent);
    coarse_.E = MatrixXd::Zero(f, d);
    coarse_.F = MatrixXd::Zero(d, d);
    coarse_.dependent_offset = VectorXd::Zero(d);
  }

  /// Cones of forces: those of tractions at the nodes times the area of the aggregate.
  void put_law(const NodalLaw& law) {
    area_ = weights_.transpose() * surface_.area;
    law_.cone.resize(weights_.cols());
    for (int a = 0; a < weights_.cols(); ++a) {
      FrictionCone& cone = law_.cone[a];
      cone.limit = 0;
      for (SparseMatrix::InnerIterator e(weights_, a); e; ++e) {
        const FrictionCone& own = law.cone[e.row()];
        cone.bonded = cone.bonded || own.bonded;
        const double area = e.value() * surface_.area[e.row()];
        cone.friction += area / area_[a] * own.friction;
        cone.cohesion += e.value() * own.cohesion;
        cone.limit += e.value() * own.limit;
      }
    }
  }

  ContactRows on_nodes(const ContactRows& coarse) const {
    VectorXd traction = coarse.P;
    for (Index row = 0; row < traction.size(); ++row)
      traction[row] /= area_[row / 3];
    ContactRows rows{R_ * traction, R_ * coarse.v};
    for (Index row = 0; row < rows.P.size(); ++row)
      rows.P[row] *= surface_.area[row / 3];
    return rows;
  }

  const ContactSurface& surface_;
  Aggregates aggregates_;
  SparseMatrix weights_;  ///< [p x a]
  SparseMatrix R_;        ///< [3p x 3a]
  VectorXd area_;         ///< of the aggregates [mm^2, a]
  CondensedContact coarse_;
  Flags held_;  ///< [3a]
  NodalLaw law_;
};

}  // namespace

std::optional<ContactRows> coarse_start(const CondensedContact& contact,
                                        const NodalLaw& law,
                                        const ContactSurface& surface) {
  return Coarse(law, surface).rows(contact);
}

}  // namespace ffcontact
