// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "estimate/oscillation.hpp"
#include "freefem/arguments.hpp"
#include "problem/solid_contact.hpp"

namespace ffcontact::plugin {

/// Reads elastic law, initial strains and stresses and loads of solids into what is judged.
using ReadSolids =
    std::function<Oscillation(const Bodies<3>& bodies, SolvedBody<3>& body)>;

/// Steps of the relaxation of solids in what the script calls a sweep.
constexpr int steps_of_a_sweep = 4;

/// What contactsolve found, without its elastic law and its loads.
SolvedBody<3> judged_body(const SolvedSolid& solved);

/// contacterror(C, ...) for the contact of a mesh3 that contactsolve has solved.
/// The contact keeps what was made of it.
/// @return eps
double solid_error(Stack stack, const NamedArguments& named,
                   SolidContact& contact, const ReadSolids& read,
                   const RelaxFacets<3>& relax = relax_facets<3>);

}  // namespace ffcontact::plugin
