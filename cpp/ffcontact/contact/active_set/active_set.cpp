// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "ffcontact/contact/active_set/next_states.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Steps that may fail to lower the number of contradictions.
constexpr int most_failures = 10;

using States = ContactStates;

/// Counts the steps that fail to lower the number of contradictions.
class Patience {
 public:
  /// @return whether that was one too many
  bool ends_with(int contradictions) {
    if (contradictions < fewest_) {
      fewest_ = contradictions;
      left_ = most_failures;
    }
    return left_-- == 0;
  }

 private:
  int fewest_ = std::numeric_limits<int>::max(), left_ = most_failures;
};

int differences(const States& a, const States& b) {
  return static_cast<int>(std::inner_product(
      a.begin(), a.end(), b.begin(), 0, std::plus<>(), std::not_equal_to<>()));
}

/// The closed state of an open node that touches.
ContactState closed_by_touch(const FrictionCone& cone, ContactState open,
                             double vt, const Rounding& rounding) {
  if (cone.frictionless()) return ContactState::slip_forward;
  return closed_state(cone.depends_on_contact() ? slip_direction(vt, rounding)
                                                : slip_sign(open));
}

/// Where a prescribed end and its neighbour both touch, both are closed: the end's
/// multiplier is then continued. One of them open may be as good an answer to the
/// conditions, but leaves the pressures beside it oscillating.
States with_touching_ends_closed(const CondensedContact& contact,
                                 const NodalLaw& law, const ContactRows& rows,
                                 States state) {
  const Rounding rounding = rounding_of(contact, rows);
  const auto touches = [&](int node) {
    return std::abs(rows.v[2 * node]) <= rounding.motion;
  };
  for (std::size_t d = 0; d < contact.dependent.size(); ++d) {
    if (contact.dependent[d] % 2 != 0 || contact.continued[d] < 0) continue;
    if (!contact.loads_the_body(static_cast<Index>(d))) continue;
    const int end = contact.dependent[d] / 2,
              neighbour = contact.continued[d] / 2;
    if (is_open(state[end]) == is_open(state[neighbour]) || !touches(end) ||
        !touches(neighbour))
      continue;
    const int node = is_open(state[end]) ? end : neighbour;
    state[node] = closed_by_touch(law.cone[node], state[node],
                                  rows.v[2 * node + 1], rounding);
  }
  return state;
}

/// Takes the answer with touching ends closed in place of a converged one, if it is one
/// too.
void close_touching_ends(const CondensedContact& contact, const NodalLaw& law,
                         double tolerance, ActiveSetResult& result) {
  ContactRows rows{result.P, result.v};
  const States closed =
      with_touching_ends_closed(contact, law, rows, result.state);
  if (closed == result.state) return;
  ++result.iterations;
  const SystemKind kind = solve_active_set(contact, law, closed, rows);
  if (kind == SystemKind::inconsistent ||
      next_states(contact, law, closed, rows) != closed)
    return;
  const double violation = law_violation(contact, law, rows);
  if (violation <= tolerance) result.keep(closed, rows, violation);
}

/// The largest force of loads, or that of prescribed displacements.
double load_scale(const CondensedContact& contact) {
  const double prescribed = contact.dependent_offset.lpNorm<Eigen::Infinity>();
  return std::max(max_norm(contact.g),
                  contact.S.diagonal().maxCoeff() * prescribed);
}

/// Notes that the iteration has ended, and brings an answer into the law.
void finish(const CondensedContact& contact, const NodalLaw& law,
            const NewtonSettings& settings, ActiveSetResult& result) {
  if (result.violation <= settings.tolerance)
    result.status = ContactStatus::converged;
  if (result.status != ContactStatus::converged) return;
  if (result.iterations < settings.max_iterations)
    close_touching_ends(contact, law, settings.tolerance, result);
  put_into_law(law, result.state, result.P);
}

}  // namespace

LawScales law_scales(const CondensedContact& contact, const VectorXd& v) {
  constexpr double share_of_loads = 1e-4;
  return {motion_scale(contact, v), share_of_loads * max_norm(contact.g)};
}

double law_violation(const CondensedContact& contact, const NodalLaw& law,
                     const ContactRows& rows) {
  constexpr double most_of_loads = 1e10;
  if (max_norm(loading_multipliers(contact, rows.P)) >
      most_of_loads * load_scale(contact))
    return infinity;
  Flags idle(law.node_count(), 0);
  for (std::size_t d = 0; d < contact.dependent.size(); ++d)
    if (contact.dependent[d] % 2 == 1)
      idle[contact.dependent[d] / 2] =
          !contact.loads_the_body(static_cast<Index>(d));
  return law_violation(law, rows.P, rows.v, law_scales(contact, rows.v), idle);
}

ActiveSetResult active_set_newton(const CondensedContact& contact,
                                  const NodalLaw& law, States state,
                                  const NewtonSettings& settings) {
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] = start_state(law.cone[i], state[i]);

  constexpr double unknown = infinity;
  const VectorXd zero = VectorXd::Zero(contact.position.size());
  ContactRows rows{zero, zero};
  ActiveSetResult result;
  result.violation = unknown;
  Patience patience;
  for (bool ends = false;
       !ends && result.iterations < settings.max_iterations;) {
    ++result.iterations;
    const SystemKind kind = solve_active_set(contact, law, state, rows);
    const bool held = kind != SystemKind::inconsistent;
    const double violation = held ? law_violation(contact, law, rows) : unknown;
    tell(settings.report,
         {"Newton", result.iterations, "violation", violation});
    const States next = next_states(contact, law, state, rows);
    const bool settled = next == state;
    if (settled || violation < result.violation || result.iterations == 1)
      result.keep(state, rows, violation);
    ends = settled || patience.ends_with(differences(state, next));
    if (settled)
      result.status =
          held ? ContactStatus::inaccurate : ContactStatus::singular;
    else if (ends)
      result.status = ContactStatus::cycled;
    state = next;
  }
  finish(contact, law, settings, result);
  return result;
}

}  // namespace ffcontact
