// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "ffcontact/base/norms.hpp"

namespace ffcontact {

namespace {

/// Below this, relative to the largest multiplier (or load on the line) or displacement,
/// a contradiction is rounding.
constexpr double relative_rounding = 1e-12;
/// A closed node that moves by more than this, relative to the largest displacement, is
/// moved by a prescribed dof.
constexpr double relative_motion = 1e-11;
/// Steps that may fail to lower the number of contradictions.
constexpr int most_failures = 10;

using States = std::vector<ContactState>;

struct Rounding {
  double P, v;
  double motion;  ///< of a closed node
};

/// Which way a node slides, 0 if it does not move.
int direction(double vt, const Rounding& rounding) {
  return vt > rounding.v ? 1 : vt < -rounding.v ? -1 : 0;
}

ContactState closed_state(int slip) {
  return slip > 0   ? ContactState::slip_forward
         : slip < 0 ? ContactState::slip_backward
                    : ContactState::stick;
}

ContactState limited_state(int slip) {
  return slip > 0 ? ContactState::limited_forward
                  : ContactState::limited_backward;
}

ContactState open_state(int slip) {
  return slip > 0   ? ContactState::open_slip_forward
         : slip < 0 ? ContactState::open_slip_backward
                    : ContactState::open_stick;
}

/// What the answer makes of the slip of a node that friction holds.
int next_slip(double Pt, double vt, double bound, int slip,
              const Rounding& rounding) {
  if (slip != 0) return slip * vt < -rounding.v ? 0 : slip;
  if (std::abs(vt) > rounding.motion) return direction(vt, rounding);
  if (std::abs(Pt) <= bound + rounding.P) return 0;
  return Pt < 0 ? 1 : -1;
}

bool next_open(double Pn, double vn, bool open, const Rounding& rounding) {
  return open ? vn <= rounding.v : Pn > rounding.P || vn < -rounding.motion;
}

/// With a bound that is given, which holds open places, too.
ContactState next_state_with_bound(double bound, bool open, ContactState now,
                                   double Pt, double vt,
                                   const Rounding& rounding) {
  const int slip = next_slip(Pt, vt, bound, slip_sign(now), rounding);
  return open ? open_state(slip) : closed_state(slip);
}

/// With friction that grows with -P_n.
ContactState next_closed_state(const FrictionCone& cone, ContactState now,
                               const Vector2d& P, double vt,
                               const Rounding& rounding) {
  const int slip =
      now == ContactState::open
          ? direction(vt, rounding)
          : next_slip(P[1], vt, cone.bound(P[0]), slip_sign(now), rounding);
  return slip != 0 && cone.at_limit(P[0]) ? limited_state(slip)
                                          : closed_state(slip);
}

/// @param P, v  of the node
ContactState next_state(const FrictionCone& cone, ContactState now,
                        const Vector2d& P, const Vector2d& v,
                        const Rounding& rounding) {
  const bool open = next_open(P[0], v[0], is_open(now), rounding);
  if (cone.frictionless())
    return open ? ContactState::open : ContactState::slip_forward;
  if (!cone.depends_on_contact())
    return next_state_with_bound(cone.cohesion, open, now, P[1], v[1],
                                 rounding);
  return open ? ContactState::open
              : next_closed_state(cone, now, P, v[1], rounding);
}

/// The nearest state that a node may have.
ContactState start_state(const FrictionCone& cone, ContactState state) {
  if (cone.frictionless())
    return is_open(state) ? ContactState::open : ContactState::slip_forward;
  if (!is_open(state)) return state;
  return cone.depends_on_contact() ? ContactState::open
                                   : open_state(slip_sign(state));
}

Rounding rounding_of(const CondensedContact& contact, const ContactRows& rows) {
  const double P_largest = std::max(max_norm(rows.P), max_norm(contact.g));
  const double v_largest = motion_scale(contact, rows.v);
  return {relative_rounding * P_largest, relative_rounding * v_largest,
          relative_motion * v_largest};
}

/// The sticking row that moves a dependent row most, -1 if none does.
int strongest_stick(const CondensedContact& contact, const States& state,
                    Index d) {
  int strongest = -1;
  double most = 0;
  for (std::size_t k = 0; k < contact.primary.size(); ++k) {
    const int row = contact.primary[k];
    const double share = std::abs(contact.E(static_cast<Index>(k), d));
    if (row % 2 == 0 || state[row / 2] != ContactState::stick || share <= most)
      continue;
    strongest = static_cast<int>(k);
    most = share;
  }
  return strongest;
}

/// Two nodes of one vertex that are closed hold it where their lines meet. Where one of
/// them sticks elsewhere the other one penetrates, and nothing is left to move it: the
/// first one has to slip.
void release_sticks(const CondensedContact& contact, const States& state,
                    const ContactRows& rows, const Rounding& rounding,
                    States& next) {
  for (std::size_t d = 0; d < contact.dependent.size(); ++d) {
    const int row = contact.dependent[d];
    if (row % 2 != 0 || is_open(state[row / 2]) ||
        rows.v[row] <= rounding.motion)
      continue;
    const auto column = static_cast<Index>(d);
    const int k = strongest_stick(contact, state, column);
    if (k >= 0)
      next[contact.primary[k] / 2] =
          closed_state(contact.E(k, column) > 0 ? -1 : 1);
  }
}

States next_states(const CondensedContact& contact, const NodalLaw& law,
                   const States& state, const ContactRows& rows) {
  const Rounding rounding = rounding_of(contact, rows);
  States next(state.size());
  for (int i = 0; i < law.node_count(); ++i)
    next[i] = next_state(law.cone[i], state[i], rows.P.segment<2>(2 * i),
                         rows.v.segment<2>(2 * i), rounding);
  release_sticks(contact, state, rows, rounding, next);
  return next;
}

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

void keep(const States& state, const ContactRows& rows, double violation,
          ActiveSetResult& result) {
  result.P = rows.P;
  result.v = rows.v;
  result.state = state;
  result.violation = violation;
}

/// The closed state of an open node that touches.
ContactState closed_by_touch(const FrictionCone& cone, ContactState open,
                             double vt, const Rounding& rounding) {
  if (cone.frictionless()) return ContactState::slip_forward;
  return closed_state(cone.depends_on_contact() ? direction(vt, rounding)
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
  if (violation <= tolerance) keep(closed, rows, violation, result);
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
  if (max_norm(rows.P) > most_of_loads * load_scale(contact)) return infinity;
  return law_violation(law, rows.P, rows.v, law_scales(contact, rows.v));
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
    const States next = next_states(contact, law, state, rows);
    const bool settled = next == state;
    if (settled || violation < result.violation || result.iterations == 1)
      keep(state, rows, violation, result);
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
