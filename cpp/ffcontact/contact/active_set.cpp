// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ffcontact {

namespace {

/// Below this, relative to the largest multiplier (or load on the line) or displacement, a contradiction is rounding.
constexpr double rounding = 1e-12;
/// A closed node that moves by more than this, relative to the largest displacement, is moved by a prescribed dof.
constexpr double moved = 1e-11;
/// Steps in which all contradicted nodes may change although the contradictions do not get fewer.
constexpr int patience = 10;

using States = std::vector<ContactState>;

/// State of a closed node that moves by v_t.
ContactState sliding(double vt, double v_rounding) {
  if (vt > v_rounding) return ContactState::slip_forward;
  return vt < -v_rounding ? ContactState::slip_backward : ContactState::stick;
}

ContactState next_state(const NodalLaw& law, int node, ContactState now, const ContactRows& rows, double p_rounding,
                        double v_rounding) {
  const double Pn = rows.P[2 * node], Pt = rows.P[2 * node + 1];
  const double vn = rows.v[2 * node], vt = rows.v[2 * node + 1];
  if (now == ContactState::open) {
    if (vn <= v_rounding) return now;
    return law.frictionless(node) ? ContactState::slip_forward : sliding(vt, v_rounding);
  }
  if (Pn > p_rounding || vn < -v_rounding * (moved / rounding)) return ContactState::open;
  if (law.frictionless(node)) return now;
  if (now == ContactState::stick) {
    if (std::abs(vt) > v_rounding * (moved / rounding)) return sliding(vt, v_rounding);
    if (std::abs(Pt) <= law.bound(node, Pn) + p_rounding) return now;
    return Pt < 0 ? ContactState::slip_forward : ContactState::slip_backward;
  }
  return slip_sign(now) * vt < -v_rounding ? ContactState::stick : now;
}

States next_states(const CondensedContact& contact, const NodalLaw& law, const States& state, const ContactRows& rows) {
  const double p_rounding = rounding * std::max(rows.P.cwiseAbs().maxCoeff(), contact.g.cwiseAbs().maxCoeff());
  const double v_rounding = rounding * rows.v.cwiseAbs().maxCoeff();
  States next(state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    next[i] = next_state(law, static_cast<int>(i), state[i], rows, p_rounding, v_rounding);
  return next;
}

/// Puts the multipliers of an answer exactly into the law; they miss it by no more than rounding.
void settle(const NodalLaw& law, const States& state, Eigen::VectorXd& P) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    double &Pn = P[2 * i], &Pt = P[2 * i + 1];
    Pn = std::min(Pn, 0.0);
    const double bound = state[i] == ContactState::open ? 0 : law.bound(static_cast<int>(i), Pn);
    Pt = slip_sign(state[i]) != 0 ? -slip_sign(state[i]) * bound : std::clamp(Pt, -bound, bound);
  }
}

/// Which of the contradicted nodes change: all, or the last one when that has not helped for a while.
class Pivoting {
 public:
  explicit Pivoting(bool ends) : ends_(ends) {}

  /// @return false when the set to come was tried before, or single changes that need not end have not helped for a while
  bool change(States& state, const States& next) {
    std::vector<std::size_t> contradicted;
    for (std::size_t i = 0; i < state.size(); ++i)
      if (next[i] != state[i]) contradicted.push_back(i);
    if (contradicted.size() < fewest_) {
      fewest_ = contradicted.size();
      patience_left_ = patience;
      tried_.clear();
    }
    if (patience_left_-- > 0) {
      state = next;
      return true;
    }
    state[contradicted.back()] = next[contradicted.back()];
    return tried_.insert(state).second && (ends_ || static_cast<int>(tried_.size()) <= 2 * patience);
  }

 private:
  const bool ends_;  ///< single changes are known to end
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  int patience_left_ = patience;
  std::set<States> tried_;
};

void keep(const States& state, const ContactRows& rows, double violation, ActiveSetResult& result) {
  result.P = rows.P;
  result.v = rows.v;
  result.state = state;
  result.violation = violation;
}

}  // namespace

ActiveSetResult active_set_newton(const CondensedContact& contact, const NodalLaw& law, States state,
                                  const NewtonSettings& settings) {
  for (std::size_t i = 0; i < state.size(); ++i)
    if (law.frictionless(static_cast<int>(i)) && state[i] != ContactState::open) state[i] = ContactState::slip_forward;

  ActiveSetResult result;
  result.violation = std::numeric_limits<double>::infinity();
  ContactRows rows{Eigen::VectorXd::Zero(contact.position.size()), Eigen::VectorXd::Zero(contact.position.size())};
  Pivoting pivoting(law.tresca() || law.friction.isZero(0));
  while (result.iterations < settings.max_iterations) {
    ++result.iterations;
    const SystemKind kind = solve_active_set(contact, law, state, rows);
    const bool held = kind != SystemKind::inconsistent;
    const double violation =
        held ? law_violation(law, rows.P, rows.v, rows.v.cwiseAbs().maxCoeff()) : std::numeric_limits<double>::infinity();
    const States next = next_states(contact, law, state, rows);
    const bool settled = next == state;
    if (settled || violation < result.violation || result.iterations == 1) keep(state, rows, violation, result);
    if (settled) {
      result.status = held ? ContactStatus::converged : ContactStatus::singular;
      break;
    }
    if (!pivoting.change(state, next)) {
      result.status = ContactStatus::cycled;
      break;
    }
  }
  if (result.violation <= settings.tolerance) result.status = ContactStatus::converged;
  if (result.status == ContactStatus::converged) settle(law, result.state, result.P);
  return result;
}

}  // namespace ffcontact
