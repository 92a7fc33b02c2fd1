// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact_problem.hpp"
#include "ffcontact/estimate/estimate.hpp"

namespace ffcontact::plugin {

/// Reads elastic law (lambda= and G=, or hooke=) and loads (traction=, bodyforce=) of all
/// bodies into what is judged.
/// @return oscillation of the body forces (BodyForce)
/// @throws std::invalid_argument  if a body has not one elastic law
double read_material_and_loads(Stack stack, const NamedArguments& named,
                               const ContactProblem& problem, SolvedBody& body);

}  // namespace ffcontact::plugin
