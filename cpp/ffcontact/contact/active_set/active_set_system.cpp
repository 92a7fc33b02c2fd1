// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/active_set_system.hpp"

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
             const ContactStates& state)
      : contact_(contact), scale_(unknown_scales(contact)) {
    for (int row = 0; row < contact.position.size(); ++row)
      conditions_.push_back(row_condition(law, row, state[row / 2]));
    for (std::size_t k = 0; k < contact.primary.size(); ++k)
      if (!conditions_[contact.primary[k]].on_displacement)
        unknown_.push_back(static_cast<int>(k));
  }

  SystemKind solve(ContactRows& rows) {
    assemble();
    SystemKind kind = SystemKind::regular;
    RefinedSolver solver;
    const VectorXd x =
        solved(transposed_, right_, count_of(unknown_), kind, solver);
    if (!x.allFinite()) return SystemKind::inconsistent;
    const Index n = count_of(unknown_);
    VectorXd v = VectorXd::Zero(contact_.S.rows());
    for (Index j = 0; j < n; ++j) v[unknown_[j]] = scale_.v[unknown_[j]] * x[j];
    spread(v, scale_.q.cwiseProduct(x.tail(scale_.q.size())), rows);
    return kind;
  }

  MatrixXd matrix() {
    assemble();
    return transposed_.transpose();
  }

 private:
  /// Adds factor * P_row to equation e.
  void add_multiplier(Index e, int row, double factor) {
    const Index n = count_of(unknown_);
    const int k = contact_.position[row];
    if (k < 0) {
      transposed_(n - 1 - k, e) += factor * scale_.q[-1 - k];
      return;
    }
    for (Index j = 0; j < n; ++j)
      transposed_(j, e) +=
          factor * contact_.S(unknown_[j], k) * scale_.v[unknown_[j]];
    for (Index d = 0; d < contact_.E.cols(); ++d)
      transposed_(n + d, e) -= factor * contact_.E(k, d) * scale_.q[d];
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
      transposed_(j, e) =
          scale_.q[d] * contact_.E(unknown_[j], d) * scale_.v[unknown_[j]];
      steering += std::abs(contact_.E(unknown_[j], d));
    }
    for (Index j = 0; j < contact_.F.cols(); ++j) {
      transposed_(n + j, e) = scale_.q[d] * contact_.F(d, j) * scale_.q[j];
      steering += std::abs(transposed_(n + j, e));
    }
    right_[e] = -scale_.q[d] * contact_.dependent_offset[d];
    if (steering < unsteered) continuation_equation(e, d);
  }

  /// The multiplier is that of the row it is continued from, or 0.
  void continuation_equation(Index e, Index d) {
    transposed_.col(e).setZero();
    right_[e] = 0;
    add_multiplier(e, contact_.dependent[d], 1 / scale_.q[d]);
    if (contact_.loads_the_body(d) && contact_.continued[d] >= 0)
      add_multiplier(e, contact_.continued[d], -1 / scale_.q[d]);
  }

  void assemble() {
    const Index n = count_of(unknown_), d = contact_.E.cols();
    transposed_ = MatrixXd::Zero(n + d, n + d);
    right_ = VectorXd::Zero(n + d);
    for (Index e = 0; e < n; ++e)
      multiplier_equation(e, contact_.primary[unknown_[e]],
                          scale_.v[unknown_[e]]);
    for (Index k = 0; k < d; ++k) {
      const int row = contact_.dependent[k];
      if (conditions_[row].on_displacement)
        dependent_displacement_equation(n + k, k);
      else
        multiplier_equation(n + k, row, 1 / scale_.q[k]);
    }
  }

  void spread(const VectorXd& v, const VectorXd& q, ContactRows& rows) const {
    rows = rows_of(contact_, v, q);
    for (int row = 0; row < rows.P.size(); ++row)
      if (!conditions_[row].on_displacement) rows.P[row] = given_P(row, rows.P);
  }

  /// Exactly, so that a body without contact has no forces of rounding size.
  double given_P(int row, const VectorXd& P) const {
    const RowCondition& condition = conditions_[row];
    if (condition.ratio == 0) return condition.value;
    return condition.value + condition.ratio * P[row - 1];
  }

  const CondensedContact& contact_;
  const UnknownScales scale_;
  VectorXd right_;
  std::vector<RowCondition> conditions_;
  std::vector<int> unknown_;
  MatrixXd transposed_;  ///< an equation is a column
};

}  // namespace

SystemKind solve_active_set(const CondensedContact& contact,
                            const NodalLaw& law, const ContactStates& state,
                            ContactRows& rows) {
  return LinearStep(contact, law, state).solve(rows);
}

MatrixXd active_set_matrix(const CondensedContact& contact, const NodalLaw& law,
                           const ContactStates& state) {
  return LinearStep(contact, law, state).matrix();
}

}  // namespace ffcontact
