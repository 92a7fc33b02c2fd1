// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/active_set/active_set_system.hpp"

/// What the answer of a linear system makes of the states of the nodes.
namespace ffcontact {

/// What contradicts a state by less is rounding.
struct Rounding {
  double P, v;
  double motion;  ///< of a closed node
};
Rounding rounding_of(const CondensedContact& contact, const ContactRows& rows);

/// Which way a node slides, 0 if it does not move.
int slip_direction(double vt, const Rounding& rounding);

/// @param slip  1 along t, -1 against t, 0 where it sticks
ContactState closed_state(int slip);
/// Likewise, where friction does not ask for contact.
ContactState open_state(int slip);

/// The nearest state that a node may have.
ContactState start_state(const FrictionCone& cone, ContactState state);

/// The states that contradict the answer least: nodes that pull open, those that penetrate
/// close, those that slide or bear more than friction holds slip.
ContactStates next_states(const CondensedContact& contact, const NodalLaw& law,
                          const ContactStates& state, const ContactRows& rows);

}  // namespace ffcontact
