// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact_problem.hpp"
#include "packet.hpp"
#include "shared_contact.hpp"
#include "solid_contact.hpp"

/// What of the contact nodes a process shows to its script.
namespace ffcontact::plugin {

/// The nodes at the vertices of one process's parts.
template <class Problem, int dim>
std::vector<int> nodes_of(const Problem& problem,
                          const SharedBodies<dim>& bodies, int rank);

/// Those nodes, without what a solution leaves there.
ShownNodes shown_nodes(const ContactProblem& problem,
                       const SharedBodies<2>& bodies, int rank);
ShownNodes shown_nodes(const SolidProblem& problem,
                       const SharedBodies<3>& bodies, int rank);

/// What a solution left at some of the nodes.
void take(const NodalResults& all, const std::vector<int>& nodes,
          ShownNodes& shown);
void take(const SolidResults& all, const std::vector<int>& nodes,
          ShownNodes& shown);

void put(const ShownNodes& nodes, Packet& packet);
ShownNodes nodes_in(Packet& packet);

}  // namespace ffcontact::plugin
