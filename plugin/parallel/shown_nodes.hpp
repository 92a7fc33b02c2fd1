// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parallel/packet.hpp"
#include "parallel/shared_contact.hpp"
#include "problem/contact_problem.hpp"

/// What of the contact nodes a process shows to its script.
namespace ffcontact::plugin {

/// The nodes at the vertices of one process's parts.
/// @param solved  what a solution left at all nodes; null: nothing
template <int d>
ShownNodes shown_nodes(const ContactProblem<d>& problem,
                       const SharedBodies<d>& bodies, int rank,
                       const NodalResults* solved = nullptr);

void put(const ShownNodes& nodes, Packet& packet);
ShownNodes nodes_in(Packet& packet);

}  // namespace ffcontact::plugin
