// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// contactsolve on plane bodies; returns the iterations.
long solve_plane(const SolveCall& call, Contact& contact);

/// Results at the nodes, node= and abscissa= of them.
void put(const SolveCall& call, const std::vector<long>& own_vertex,
         const VectorXd& abscissa, const NodalResults& nodes);

}  // namespace ffcontact::plugin
