// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/newton/inexact_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <iterator>
#include <utility>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/iterative/gmres.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A factor is made anew after so many steps of GMRES, and where more than this part of the
/// unknowns are others.
constexpr int most_steps_with_factor = 15;
constexpr double most_changed = 0.05;
/// Residual of GMRES that is of no use.
constexpr double unsolved = 0.1;
/// Share of D in the preconditioner, so that T = I - D is regular.
constexpr double share_of_D = 0.9999;

/// Of sorted lists: how many are in one of them only.
int changed(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> different;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(different));
  return count_of(different);
}

/// v of all primary rows, 0 where that is the condition.
VectorXd free_part(const CondensedContact& contact,
                   const SurfaceEquations& equations, const VectorXd& v) {
  VectorXd result = v(contact.primary);
  for (Index k = 0; k < result.size(); ++k)
    if (equations.is_fixed(contact.primary[k])) result[k] = 0;
  return result;
}

std::vector<int> unknown_places(const SingleStiffness& S,
                                const SurfaceEquations& equations) {
  return numbers_where(S.size(),
                       [&](int p) { return !equations.is_fixed(S.row(p)); });
}

}  // namespace

/// Rows and unknowns are multiplied and divided by R of S.
class InexactStep::System {
 public:
  System(const SingleStiffness& S, const SurfaceEquations& equations)
      : S_(S),
        equations_(equations),
        places_(unknown_places(S, equations)),
        number_(S.size(), -1) {
    for (int p : places_) {
      const int row = S.row(p);
      number_[p] = count_of(rows_);
      rows_.push_back(equations.equation(row));
      inverse_.push_back(row_of_inverse(row));
    }
  }

  const std::vector<int>& places() const { return places_; }

  /// What P and v miss, scaled [n].
  VectorXd residual(const ContactRows& at) const {
    VectorXd right(places_.size());
    for (Index e = 0; e < right.size(); ++e) {
      double sum = rows_[e].value;
      for (const Term& term : rows_[e].terms)
        sum -= term.P * at.P[term.row] + term.v * at.v[term.row];
      right[e] = S_.scale(places_[e]) * sum;
    }
    return right;
  }

  VectorXf product(const VectorXf& x) const {
    const VectorXf forces = S_.product(places_, x);
    VectorXf result(x.size());
    for (Index e = 0; e < x.size(); ++e) {
      double sum = 0;
      for (const Term& term : rows_[e].terms) {
        const int p = S_.place(term.row), other = number_[p];
        sum += term.P * forces[p] / S_.scale(p);
        if (other >= 0) sum += term.v * S_.scale(p) * x[other];
      }
      result[e] = static_cast<float>(S_.scale(places_[e]) * sum);
    }
    return result;
  }

  Factor factor() const {
    MatrixXf M = S_.lower_block(places_);
    for (int e = 0; e < count_of(places_); ++e)
      for (int c = 1; c < 3; ++c)
        if (const int d = neighbour(e, c); d >= e) {
          const double own = inverse_[e][c - 1] - (d == e);
          M(d, e) += static_cast<float>(
              stiffness(e) * own * S_.scale(places_[e]) * S_.scale(places_[d]));
        }
    return {places_, LapackCholesky<float>(std::move(M))};
  }

  /// T^-1, then the factor where it has these unknowns.
  VectorXf preconditioned(const Factor& factor, const VectorXf& x) const {
    VectorXf result = divided(x);
    VectorXf known = VectorXf::Zero(factor.cholesky.size());
    for (Index k = 0; k < known.size(); ++k)
      if (const int e = number_[factor.places[k]]; e >= 0) known[k] = result[e];
    known = factor.cholesky.solve(std::move(known));
    for (Index k = 0; k < known.size(); ++k)
      if (const int e = number_[factor.places[k]]; e >= 0) result[e] = known[k];
    return result;
  }

  /// P and v + an increment of v.
  void move(double size, const VectorXf& x, ContactRows& rows) const {
    const VectorXf forces = S_.product(places_, x);
    for (int p = 0; p < S_.size(); ++p)
      rows.P[S_.row(p)] += size * forces[p] / S_.scale(p);
    for (std::size_t e = 0; e < places_.size(); ++e)
      rows.v[S_.row(places_[e])] += size * x[e] * S_.scale(places_[e]);
  }

 private:
  int row(int e) const { return S_.row(places_[e]); }
  double stiffness(int e) const { return equations_.stiffness(row(e) / 3); }

  /// The unknown of component c at the node of a tangential unknown, or -1.
  int neighbour(int e, int c) const {
    const int p = S_.place(row(e) / 3 * 3 + c);
    return row(e) % 3 == 0 || p < 0 ? -1 : number_[p];
  }

  /// Of T^-1 on the tangential rows of a node.
  Vector2d row_of_inverse(int row) const {
    if (row % 3 == 0) return Vector2d::Zero();
    const Matrix2d T =
        Matrix2d::Identity() - share_of_D * equations_.derivative(row / 3);
    return T.inverse().row(row % 3 - 1);
  }

  /// T^-1 x
  VectorXf divided(const VectorXf& x) const {
    VectorXf result = x;
    for (int e = 0; e < count_of(places_); ++e) {
      if (row(e) % 3 == 0) continue;
      double sum = 0;
      for (int c = 1; c < 3; ++c)
        if (const int d = neighbour(e, c); d >= 0)
          sum += inverse_[e][c - 1] * x[d] / S_.scale(places_[d]);
      result[e] = static_cast<float>(S_.scale(places_[e]) * sum);
    }
    return result;
  }

  const SingleStiffness& S_;
  const SurfaceEquations& equations_;
  std::vector<int> places_;        ///< of the unknowns, ascending
  std::vector<int> number_;        ///< of the unknown at each place, or -1
  std::vector<Equation> rows_;     ///< of the unknowns
  std::vector<Vector2d> inverse_;  ///< row_of_inverse of the unknowns
};

bool InexactStep::needs_new_factor(const std::vector<int>& places) const {
  return !factor_ || factor_->steps > most_steps_with_factor ||
         changed(places, factor_->places) > most_changed * count_of(places);
}

bool InexactStep::solve(const CondensedContact& contact,
                        const SurfaceEquations& equations, ContactRows& rows) {
  const VectorXd no_multipliers = VectorXd::Zero(contact.E.cols());
  ContactRows next =
      rows_of(contact, free_part(contact, equations, rows.v), no_multipliers);
  for (int row : contact.dependent) next.v[row] = 0;
  if (!advance(System(S_, equations), next)) return false;
  rows = std::move(next);
  return true;
}

bool InexactStep::advance(const System& system, ContactRows& rows) {
  const VectorXd right = system.residual(rows);
  const double size = max_norm(right);
  if (size == 0) return true;
  if (needs_new_factor(system.places())) factor_ = system.factor();
  if (!factor_->cholesky.is_positive_definite()) return false;
  const GmresResult step = gmres(
      [&](const VectorXf& x) { return system.product(x); },
      [&](const VectorXf& x) { return system.preconditioned(*factor_, x); },
      (right / size).cast<float>());
  factor_->steps = step.steps;
  if (!(step.residual < unsolved) || !step.x.allFinite()) return false;
  system.move(size, step.x, rows);
  return true;
}

}  // namespace ffcontact
