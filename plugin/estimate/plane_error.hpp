// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "estimate/judged.hpp"
#include "estimate/oscillation.hpp"
#include "problem/contact_problem.hpp"

namespace ffcontact::plugin {

/// Reads the elastic law and the loads of plane bodies into what is judged.
using ReadPlane =
    std::function<Oscillation(const Bodies<2>& bodies, SolvedBody<2>& body)>;

/// What is judged, without its elastic law and its loads.
using JudgedOf = std::function<Judged()>;

/// Does the call ask for kappa or the bound with Coulomb's law?
bool wants_bound(const NamedArguments& named);

/// contacterror(C, ...) of plane bodies.
Estimate<2> plane_error(Stack stack, const NamedArguments& named,
                        const ContactProblem<2>& problem,
                        const JudgedOf& judged_of, const ReadPlane& read);

}  // namespace ffcontact::plugin
