// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

namespace ffcontact {

namespace {

/// Below this, relative to the largest multiplier or displacement, a contradiction is rounding.
constexpr double rounding = 1e-12;
/// A dependent row that moves less than this with the unknowns cannot be steered by its multiplier, which is then taken as 0.
constexpr double unsteered = 1e-6;

/// A condition on one row: P_row - ratio P_n = value, or v_row = value.
struct RowCondition {
  bool on_displacement;
  double value;
  double ratio;  ///< of P_t to P_n where a node slips with Coulomb's law
};

RowCondition row_condition(const NodalLaw& law, int row, ContactState state) {
  const int node = row / 2;
  if (state == ContactState::open) return {false, 0, 0};
  if (row % 2 == 0) return {true, law.limit[node], 0};
  if (state == ContactState::stick) return {true, 0, 0};
  if (law.tresca_bound.size() > 0) return {false, -slip_sign(state) * law.tresca_bound[node], 0};
  return {false, 0, slip_sign(state) * law.friction[node]};
}

/// The linear system of one active set. Unknowns: v of the primary rows that are not given, then q / scale.
class LinearStep {
 public:
  LinearStep(const CondensedContact& contact, const NodalLaw& law, const std::vector<ContactState>& state)
      : contact_(contact),
        scale_(contact.S.diagonal().cwiseAbs().mean()),
        v_(Eigen::VectorXd::Zero(contact.S.rows())) {
    for (int row = 0; row < contact.position.size(); ++row) conditions_.push_back(row_condition(law, row, state[row / 2]));
    for (std::size_t k = 0; k < contact.primary.size(); ++k) {
      const RowCondition& condition = conditions_[contact.primary[k]];
      if (condition.on_displacement)
        v_[k] = condition.value;
      else
        unknown_.push_back(static_cast<int>(k));
    }
  }

  /// False when the system is singular to rounding.
  bool solve(ActiveSetResult& result) {
    assemble();
    Eigen::VectorXd q = Eigen::VectorXd::Zero(contact_.E.cols());
    if (matrix_.rows() > 0) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix_);
      if (!(lu.rcond() > 1e-14)) return false;
      const Eigen::VectorXd x = lu.solve(right_);
      const auto n = static_cast<Eigen::Index>(unknown_.size());
      for (Eigen::Index j = 0; j < n; ++j) v_[unknown_[j]] = x[j];
      q = scale_ * x.tail(q.size());
    }
    spread(q, result);
    return v_.allFinite();
  }

 private:
  /// Adds factor * P_row to equation e.
  void add_multiplier(Eigen::Index e, int row, double factor) {
    const auto n = static_cast<Eigen::Index>(unknown_.size());
    const int k = contact_.position[row];
    if (k < 0) {
      matrix_(e, n - 1 - k) += factor * scale_;
      return;
    }
    for (Eigen::Index j = 0; j < n; ++j) matrix_(e, j) += factor * contact_.S(unknown_[j], k);
    for (Eigen::Index j = 0; j < contact_.E.cols(); ++j) matrix_(e, n + j) -= factor * scale_ * contact_.E(k, j);
    right_[e] += factor * (contact_.g[k] - given_part_[k]);
  }

  void multiplier_equation(Eigen::Index e, int row, const RowCondition& condition) {
    right_[e] = condition.value;
    add_multiplier(e, row, 1);
    if (condition.ratio != 0) add_multiplier(e, row - 1, -condition.ratio);
  }

  void dependent_displacement_equation(Eigen::Index e, Eigen::Index d, const RowCondition& condition) {
    const auto n = static_cast<Eigen::Index>(unknown_.size());
    double steering = 0;
    for (Eigen::Index j = 0; j < n; ++j) {
      matrix_(e, j) = scale_ * contact_.E(unknown_[j], d);
      steering += std::abs(contact_.E(unknown_[j], d));
    }
    if (steering < unsteered) {
      matrix_.row(e).setZero();
      matrix_(e, n + d) = scale_;
      return;
    }
    right_[e] = scale_ * (condition.value - contact_.dependent_offset[d] - contact_.E.col(d).dot(v_));
  }

  void assemble() {
    const auto n = static_cast<Eigen::Index>(unknown_.size()), d = contact_.E.cols();
    matrix_ = Eigen::MatrixXd::Zero(n + d, n + d);
    right_ = Eigen::VectorXd::Zero(n + d);
    given_part_ = contact_.S * v_;
    for (Eigen::Index e = 0; e < n; ++e) {
      const int row = contact_.primary[unknown_[e]];
      multiplier_equation(e, row, conditions_[row]);
    }
    for (Eigen::Index k = 0; k < d; ++k) {
      const int row = contact_.dependent[k];
      if (conditions_[row].on_displacement)
        dependent_displacement_equation(n + k, k, conditions_[row]);
      else
        multiplier_equation(n + k, row, conditions_[row]);
    }
  }

  void spread(const Eigen::VectorXd& q, ActiveSetResult& result) const {
    const Eigen::VectorXd P = contact_.S * v_ - contact_.g - contact_.E * q;
    const Eigen::VectorXd v_dependent = contact_.E.transpose() * v_ + contact_.dependent_offset;
    for (int row = 0; row < contact_.position.size(); ++row) {
      const int k = contact_.position[row];
      result.P[row] = k >= 0 ? P[k] : q[-1 - k];
      result.v[row] = k >= 0 ? v_[k] : v_dependent[-1 - k];
    }
  }

  const CondensedContact& contact_;
  const double scale_;  ///< makes multipliers and displacements comparable in the matrix
  std::vector<RowCondition> conditions_;
  std::vector<int> unknown_;
  Eigen::VectorXd v_, given_part_, right_;
  Eigen::MatrixXd matrix_;
};

/// State of a closed node that moves by v_t.
ContactState sliding(double vt, double v_rounding) {
  if (vt > v_rounding) return ContactState::slip_forward;
  return vt < -v_rounding ? ContactState::slip_backward : ContactState::stick;
}

ContactState next_state(const NodalLaw& law, int node, ContactState now, const ActiveSetResult& answer, double p_rounding,
                        double v_rounding) {
  const double Pn = answer.P[2 * node], Pt = answer.P[2 * node + 1];
  const double vn = answer.v[2 * node], vt = answer.v[2 * node + 1];
  if (now == ContactState::open) {
    if (vn <= law.limit[node] + v_rounding) return now;
    return law.frictionless(node) ? ContactState::slip_forward : sliding(vt, v_rounding);
  }
  if (Pn > p_rounding) return ContactState::open;
  if (law.frictionless(node)) return now;
  if (now == ContactState::stick) {
    if (std::abs(Pt) <= law.bound(node, Pn) + p_rounding) return now;
    return Pt < 0 ? ContactState::slip_forward : ContactState::slip_backward;
  }
  return slip_sign(now) * vt < -v_rounding ? ContactState::stick : now;
}

/// Puts the multipliers of an answer exactly into the law; they miss it by no more than rounding.
void settle(const NodalLaw& law, const std::vector<ContactState>& state, Eigen::VectorXd& P) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    double &Pn = P[2 * i], &Pt = P[2 * i + 1];
    Pn = std::min(Pn, 0.0);
    const double bound = state[i] == ContactState::open ? 0 : law.bound(static_cast<int>(i), Pn);
    Pt = slip_sign(state[i]) != 0 ? -slip_sign(state[i]) * bound : std::clamp(Pt, -bound, bound);
  }
}

}  // namespace

NodalLaw nodal_law(const ContactLaw& law, const ContactLine& line) {
  NodalLaw nodal;
  nodal.friction = law.friction;
  if (law.tresca())
    nodal.tresca_bound = law.multiplier == Multiplier::force ? contact_mass(line) * law.slip_bound : law.slip_bound;
  nodal.limit = law.gap.size() > 0 ? Eigen::VectorXd(weight_matrix(law.multiplier, line) * law.gap)
                                   : Eigen::VectorXd(Eigen::VectorXd::Zero(line.node_count()));
  return nodal;
}

ActiveSetResult active_set_newton(const CondensedContact& contact, const NodalLaw& law, std::vector<ContactState> state,
                                  int max_iterations) {
  const int nodes = static_cast<int>(state.size());
  for (int i = 0; i < nodes; ++i)
    if (law.frictionless(i) && state[i] != ContactState::open) state[i] = ContactState::slip_forward;

  ActiveSetResult result;
  result.P = result.v = Eigen::VectorXd::Zero(2 * nodes);
  std::set<std::vector<ContactState>> visited;
  while (result.iterations < max_iterations) {
    visited.insert(state);
    ++result.iterations;
    if (!LinearStep(contact, law, state).solve(result)) {
      result.status = ContactStatus::singular;
      break;
    }
    const double p_rounding = rounding * result.P.cwiseAbs().maxCoeff();
    const double v_rounding = rounding * result.v.cwiseAbs().maxCoeff();
    std::vector<ContactState> next(nodes);
    for (int i = 0; i < nodes; ++i) next[i] = next_state(law, i, state[i], result, p_rounding, v_rounding);
    if (next == state) {
      settle(law, state, result.P);
      result.status = ContactStatus::converged;
      break;
    }
    state = std::move(next);
    if (visited.count(state)) {
      result.status = ContactStatus::cycled;
      break;
    }
  }
  result.state = std::move(state);
  return result;
}

}  // namespace ffcontact
