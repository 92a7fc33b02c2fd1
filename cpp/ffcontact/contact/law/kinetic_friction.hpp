// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/contact/law/contact_law.hpp"

/// Coulomb's coefficient of what slips, below that of what sticks: friction that breaks away.
namespace ffcontact {

/// mu of nodes that slipped in the load step before, and between them as ContactLaw has it; of
/// a surface the former alone.
struct KineticFriction {
  VectorXd friction;  ///< [p]; empty: as what sticks
  EdgeRange between_nodes;

  bool given() const { return friction.size() > 0; }
};

/// @throws std::invalid_argument  if sizes differ, or a kinetic coefficient is negative or
///                                above the static one
void require_kinetic(const VectorXd& kinetic, const VectorXd& at_rest);

/// The states of a load step: a node at the bound of friction that has not moved has stuck.
/// @param slip   |v_t| of the nodes [mm, p]
/// @param least  what is more than rounding [mm]
ContactStates states_of_step(ContactStates states,
                             const Ref<const VectorXd>& slip, double least);

/// mu at the nodes [p]: kinetic where the last state is slip, and the given one elsewhere.
/// @throws std::invalid_argument  if sizes differ
VectorXd friction_after(const ContactStates& last, const VectorXd& at_rest,
                        const VectorXd& kinetic);

/// mu between the nodes of a line after that: linear between a node that slipped and one that
/// did not.
/// @param friction  friction_after
EdgeRange between_nodes_after(const ContactStates& last,
                              const ContactLine& line, EdgeRange between,
                              const VectorXd& friction,
                              const EdgeRange& kinetic);

/// The law of the load step after that.
template <int d>
ContactLaw<d> law_after(const ContactStates& last, ContactLaw<d> law,
                        const LineOrSurface<d>& where,
                        const KineticFriction& kinetic) {
  law.friction = friction_after(last, law.friction, kinetic.friction);
  if constexpr (d == 2)
    law.between_nodes =
        between_nodes_after(last, where, std::move(law.between_nodes),
                            law.friction, kinetic.between_nodes);
  return law;
}

/// With mu of another law.
template <int d>
ContactLaw<d> with_friction_of(const ContactLaw<d>& other, ContactLaw<d> law) {
  law.friction = other.friction;
  if constexpr (d == 2) law.between_nodes = other.between_nodes;
  return law;
}

}  // namespace ffcontact
