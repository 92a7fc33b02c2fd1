// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/newton/newton_relation.hpp"

namespace ffcontact {

/// The law of a surface with s b in place of its bound b on friction, s raised from 0 to 1,
/// every step by surface_newton from the rows of the last one and halved where that leads
/// nowhere. Where b is given (NodalLaw::is_convex) the displacements are unique and change
/// continuously with s, so that steps which are short enough arrive; with Coulomb's law
/// the solutions may turn back in s (friction_path).
///
/// A body that friction alone holds has no start.
/// @param held  of surface_trace [3 p]
/// @return      converged at s = 1, or not with a violation that is infinite
ActiveSetResult raised_friction(NewtonRelation& relation, const NodalLaw& law,
                                const Flags& held,
                                const NewtonSettings& settings);

}  // namespace ffcontact
