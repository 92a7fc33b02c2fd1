// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/contact/law/surface_law.hpp"

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

/// The law of the load step after that. Between a node of a line that slipped and one that did
/// not mu is linear.
ContactLaw law_after(const ContactStates& last, ContactLaw law,
                     const ContactLine& line, const KineticFriction& kinetic);
inline SurfaceLaw law_after(const ContactStates& last, SurfaceLaw law,
                            const ContactSurface&,
                            const KineticFriction& kinetic) {
  law.friction = friction_after(last, law.friction, kinetic.friction);
  return law;
}

/// With mu of another law.
inline ContactLaw with_friction_of(const ContactLaw& other, ContactLaw law) {
  law.friction = other.friction;
  law.between_nodes = other.between_nodes;
  return law;
}
inline SurfaceLaw with_friction_of(const SurfaceLaw& other, SurfaceLaw law) {
  law.friction = other.friction;
  return law;
}

}  // namespace ffcontact
