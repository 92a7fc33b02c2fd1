// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/active_set/next_states.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Below this, relative to the largest multiplier (or load on the line) or displacement,
/// a contradiction is rounding.
constexpr double relative_rounding = 1e-12;
/// A closed node that moves by more than this, relative to the largest displacement, is
/// moved by a prescribed dof.
constexpr double relative_motion = 1e-11;
using States = ContactStates;

ContactState limited_state(int slip) {
  return slip > 0 ? ContactState::limited_forward
                  : ContactState::limited_backward;
}

/// What the answer makes of the slip of a node that friction holds.
int next_slip(double Pt, double vt, double bound, int slip,
              const Rounding& rounding) {
  if (slip != 0) return slip * vt < -rounding.v ? 0 : slip;
  if (std::abs(vt) > rounding.motion) return slip_direction(vt, rounding);
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

int next_closed_slip(const FrictionCone& cone, ContactState now,
                     const Vector2d& P, double vt, const Rounding& rounding) {
  if (now == ContactState::open) return slip_direction(vt, rounding);
  return next_slip(P[1], vt, cone.bound(P[0]), slip_sign(now), rounding);
}

/// With friction that grows with -P_n.
ContactState next_closed_state(const FrictionCone& cone, ContactState now,
                               const Vector2d& P, double vt,
                               const Rounding& rounding) {
  const int slip = next_closed_slip(cone, now, P, vt, rounding);
  return slip != 0 && cone.at_limit(P[0]) ? limited_state(slip)
                                          : closed_state(slip);
}

/// v_t = u_t - previous is rounded like `previous` where a step moves little.
Rounding of_slip(Rounding rounding, double previous) {
  rounding.v = std::max(rounding.v, relative_rounding * std::abs(previous));
  return rounding;
}

/// @param P, v  of the node
/// @param previous  v_t without u_t
ContactState next_state(const FrictionCone& cone, ContactState now,
                        const Vector2d& P, const Vector2d& v, double previous,
                        const Rounding& rounding) {
  if (cone.bonded) return ContactState::stick;
  const bool open = next_open(P[0], v[0], is_open(now), rounding);
  if (cone.frictionless())
    return open ? ContactState::open : ContactState::slip_forward;
  if (!cone.depends_on_contact())
    return next_state_with_bound(cone.cohesion, open, now, P[1], v[1],
                                 of_slip(rounding, previous));
  return open ? ContactState::open
              : next_closed_state(cone, now, P, v[1],
                                  of_slip(rounding, previous));
}

/// The sticking row that moves a dependent row most and may slip, -1 if none does.
int strongest_stick(const CondensedContact& contact, const NodalLaw& law,
                    const States& state, Index d) {
  int strongest = -1;
  double most = 0;
  for (std::size_t k = 0; k < contact.primary.size(); ++k) {
    const int row = contact.primary[k];
    const double share = std::abs(contact.E(static_cast<Index>(k), d));
    if (row % 2 == 0 || state[row / 2] != ContactState::stick ||
        law.cone[row / 2].bonded || share <= most)
      continue;
    strongest = static_cast<int>(k);
    most = share;
  }
  return strongest;
}

/// Two nodes of one vertex that are closed hold it where their lines meet. Where one of
/// them sticks elsewhere the other one penetrates, and nothing is left to move it: the
/// first one has to slip.
void release_sticks(const CondensedContact& contact, const NodalLaw& law,
                    const States& state, const ContactRows& rows,
                    const Rounding& rounding, States& next) {
  for (std::size_t d = 0; d < contact.dependent.size(); ++d) {
    const int row = contact.dependent[d];
    if (row % 2 != 0 || is_open(state[row / 2]) ||
        rows.v[row] <= rounding.motion)
      continue;
    const auto column = static_cast<Index>(d);
    const int k = strongest_stick(contact, law, state, column);
    if (k >= 0)
      next[contact.primary[k] / 2] =
          closed_state(contact.E(k, column) > 0 ? -1 : 1);
  }
}

}  // namespace

Rounding rounding_of(const CondensedContact& contact, const ContactRows& rows) {
  const double P_largest = std::max(
      max_norm(loading_multipliers(contact, rows.P)), max_norm(contact.g));
  const double v_largest = motion_scale(contact, rows.v);
  return {relative_rounding * P_largest, relative_rounding * v_largest,
          relative_motion * v_largest};
}

int slip_direction(double vt, const Rounding& rounding) {
  return vt > rounding.v ? 1 : vt < -rounding.v ? -1 : 0;
}

ContactState closed_state(int slip) {
  return slip > 0   ? ContactState::slip_forward
         : slip < 0 ? ContactState::slip_backward
                    : ContactState::stick;
}

ContactState open_state(int slip) {
  return slip > 0   ? ContactState::open_slip_forward
         : slip < 0 ? ContactState::open_slip_backward
                    : ContactState::open_stick;
}

ContactState start_state(const FrictionCone& cone, ContactState state) {
  if (cone.bonded) return ContactState::stick;
  if (cone.frictionless())
    return is_open(state) ? ContactState::open : ContactState::slip_forward;
  if (!is_open(state)) return state;
  return cone.depends_on_contact() ? ContactState::open
                                   : open_state(slip_sign(state));
}

States next_states(const CondensedContact& contact, const NodalLaw& law,
                   const States& state, const ContactRows& rows) {
  const Rounding rounding = rounding_of(contact, rows);
  States next(state.size());
  for (int i = 0; i < law.node_count(); ++i)
    next[i] = next_state(law.cone[i], state[i], rows.P.segment<2>(2 * i),
                         rows.v.segment<2>(2 * i),
                         contact.v_prescribed[2 * i + 1], rounding);
  release_sticks(contact, law, state, rows, rounding, next);
  return next;
}

}  // namespace ffcontact
