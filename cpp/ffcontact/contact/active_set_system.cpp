// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set_system.hpp"

#include <cmath>

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// A row that the unknowns move by less than this part is none of theirs.
constexpr double unsteered = 1e-6;
/// A condition on one row: P_row - ratio P_n = value, or v_row = 0.
struct RowCondition {
  bool on_displacement;
  double value;
  double ratio;  ///< of P_t to P_n where a node slips with Coulomb's law
};

RowCondition row_condition(const NodalLaw& law, int row, ContactState state) {
  const int node = row / 2, component = row % 2;
  if (holds(state, component)) return {true, 0, 0};
  if (component == 0 || state == ContactState::open) return {false, 0, 0};
  const FrictionCone& cone = law.cone[node];
  const int slip = slip_sign(state);
  if (is_limited(state)) return {false, -slip * cone.limit, 0};
  return {false, -slip * cone.cohesion, slip * cone.friction};
}

/// Unknowns: v of the primary rows that are not given, then q, each divided by its scale.
class LinearStep {
 public:
  LinearStep(const CondensedContact& contact, const NodalLaw& law,
             const std::vector<ContactState>& state)
      : contact_(contact),
        v_scale_(
            contact.S.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse()) {
    for (int row = 0; row < contact.position.size(); ++row)
      conditions_.push_back(row_condition(law, row, state[row / 2]));
    for (std::size_t k = 0; k < contact.primary.size(); ++k)
      if (!conditions_[contact.primary[k]].on_displacement)
        unknown_.push_back(static_cast<int>(k));
    q_scale_.resize(contact.E.cols());
    for (Index d = 0; d < contact.E.cols(); ++d) q_scale_[d] = q_scale(d);
  }

  SystemKind solve(ContactRows& rows) {
    assemble();
    SystemKind kind = SystemKind::regular;
    const VectorXd x = solved(matrix_, right_, count_of(unknown_), kind);
    if (!x.allFinite()) return SystemKind::inconsistent;
    const Index n = count_of(unknown_);
    VectorXd v = VectorXd::Zero(contact_.S.rows());
    for (Index j = 0; j < n; ++j) v[unknown_[j]] = v_scale_[unknown_[j]] * x[j];
    spread(v, q_scale_.cwiseProduct(x.tail(q_scale_.size())), rows);
    return kind;
  }

  MatrixXd matrix() {
    assemble();
    return std::move(matrix_);
  }

 private:
  /// 1 / (E_d' R^2 E_d + F_dd)^(1/2), R the scale of v: what q_d moves.
  double q_scale(Index d) const {
    const double reach =
        std::hypot(contact_.E.col(d).cwiseProduct(v_scale_).norm(),
                   std::sqrt(contact_.F(d, d)));
    return 1 / (reach > 0 ? reach : v_scale_.mean());
  }

  /// Adds factor * P_row to equation e.
  void add_multiplier(Index e, int row, double factor) {
    const Index n = count_of(unknown_);
    const int k = contact_.position[row];
    if (k < 0) {
      matrix_(e, n - 1 - k) += factor * q_scale_[-1 - k];
      return;
    }
    for (Index j = 0; j < n; ++j)
      matrix_(e, j) +=
          factor * contact_.S(unknown_[j], k) * v_scale_[unknown_[j]];
    for (Index d = 0; d < contact_.E.cols(); ++d)
      matrix_(e, n + d) -= factor * contact_.E(k, d) * q_scale_[d];
    right_[e] += factor * contact_.g[k];
  }

  void multiplier_equation(Index e, int row, double row_scale) {
    const RowCondition& condition = conditions_[row];
    right_[e] = row_scale * condition.value;
    add_multiplier(e, row, row_scale);
    if (condition.ratio != 0)
      add_multiplier(e, row - 1, -row_scale * condition.ratio);
  }

  void dependent_displacement_equation(Index e, Index d) {
    const Index n = count_of(unknown_);
    double steering = 0;
    for (Index j = 0; j < n; ++j) {
      matrix_(e, j) =
          q_scale_[d] * contact_.E(unknown_[j], d) * v_scale_[unknown_[j]];
      steering += std::abs(contact_.E(unknown_[j], d));
    }
    for (Index j = 0; j < contact_.F.cols(); ++j) {
      matrix_(e, n + j) = q_scale_[d] * contact_.F(d, j) * q_scale_[j];
      steering += std::abs(matrix_(e, n + j));
    }
    right_[e] = -q_scale_[d] * contact_.dependent_offset[d];
    if (steering < unsteered) continuation_equation(e, d);
  }

  /// The multiplier is that of the row it is continued from, or 0.
  void continuation_equation(Index e, Index d) {
    matrix_.row(e).setZero();
    right_[e] = 0;
    add_multiplier(e, contact_.dependent[d], 1 / q_scale_[d]);
    if (contact_.loads_the_body(d) && contact_.continued[d] >= 0)
      add_multiplier(e, contact_.continued[d], -1 / q_scale_[d]);
  }

  void assemble() {
    const Index n = count_of(unknown_), d = contact_.E.cols();
    matrix_ = MatrixXd::Zero(n + d, n + d);
    right_ = VectorXd::Zero(n + d);
    for (Index e = 0; e < n; ++e)
      multiplier_equation(e, contact_.primary[unknown_[e]],
                          v_scale_[unknown_[e]]);
    for (Index k = 0; k < d; ++k) {
      const int row = contact_.dependent[k];
      if (conditions_[row].on_displacement)
        dependent_displacement_equation(n + k, k);
      else
        multiplier_equation(n + k, row, 1 / q_scale_[k]);
    }
  }

  void spread(const VectorXd& v, const VectorXd& q, ContactRows& rows) const {
    const VectorXd P = contact_.S * v - contact_.g - contact_.E * q;
    const VectorXd v_dependent =
        contact_.E.transpose() * v + contact_.F * q + contact_.dependent_offset;
    rows.P.resize(contact_.position.size());
    rows.v.resize(contact_.position.size());
    for (int row = 0; row < contact_.position.size(); ++row) {
      const int k = contact_.position[row];
      rows.P[row] = k >= 0 ? P[k] : q[-1 - k];
      rows.v[row] = k >= 0 ? v[k] : v_dependent[-1 - k];
      if (!conditions_[row].on_displacement) rows.P[row] = given_P(row, rows.P);
    }
  }

  /// Exactly, so that a body without contact has no forces of rounding size.
  double given_P(int row, const VectorXd& P) const {
    const RowCondition& condition = conditions_[row];
    if (condition.ratio == 0) return condition.value;
    return condition.value + condition.ratio * P[row - 1];
  }

  const CondensedContact& contact_;
  const VectorXd v_scale_;
  VectorXd q_scale_, right_;
  std::vector<RowCondition> conditions_;
  std::vector<int> unknown_;
  MatrixXd matrix_;
};

}  // namespace

SystemKind solve_active_set(const CondensedContact& contact,
                            const NodalLaw& law,
                            const std::vector<ContactState>& state,
                            ContactRows& rows) {
  return LinearStep(contact, law, state).solve(rows);
}

MatrixXd active_set_matrix(const CondensedContact& contact, const NodalLaw& law,
                           const std::vector<ContactState>& state) {
  return LinearStep(contact, law, state).matrix();
}

}  // namespace ffcontact
