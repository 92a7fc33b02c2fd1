// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ffcontact {

/// What a node does. A node that slides along +t has v_t > 0 and is pulled back, P_t =
/// -b. Tresca's friction does not ask for contact: b is given, and an open node sticks or
/// slips under it like any other.
enum class ContactState : char {
  open,
  stick,
  slip_forward,
  slip_backward,
  /// slip under the shear limit, P_t = -k; within the solver, answers say slip
  limited_forward,
  limited_backward,
  open_stick,  ///< Tresca's law only, within the solver; answers say open
  open_slip_forward,
  open_slip_backward,
};
using ContactStates = std::vector<ContactState>;
inline ContactStates all_stick(int nodes) {
  return ContactStates(nodes, ContactState::stick);
}

/// +1 for slip forward, -1 for slip backward, 0 otherwise.
inline int slip_sign(ContactState state) {
  switch (state) {
    case ContactState::slip_forward:
    case ContactState::limited_forward:
    case ContactState::open_slip_forward: return 1;
    case ContactState::slip_backward:
    case ContactState::limited_backward:
    case ContactState::open_slip_backward: return -1;
    default: return 0;
  }
}

inline bool is_open(ContactState state) {
  return state == ContactState::open || state >= ContactState::open_stick;
}

inline bool is_limited(ContactState state) {
  return state == ContactState::limited_forward ||
         state == ContactState::limited_backward;
}

/// Does a state keep a component (0 normal, 1 tangential) from moving, v = 0?
inline bool holds(ContactState state, int component) {
  return component == 0 ? !is_open(state)
                        : state != ContactState::open && slip_sign(state) == 0;
}

}  // namespace ffcontact
