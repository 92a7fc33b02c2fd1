// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"

namespace ffcontact {

/// The law of a surface where friction alone holds a body, which Newton lets go as long as
/// its states are wrong and friction_path cannot start from: with springs that pull v to 0,
///     P = (S + eps diag(S)) v - g - E q,      eps = 1e-2, 1e-3, ..., 1e-7, 0,
/// every step from the rows of the last one, the first by surface_newton or friction_path.
/// A body that slides has |v| ~ 1 / eps.
/// @param held  of surface_trace [3 p]
/// @return      converged; singular where bodies slide; or otherwise not
ActiveSetResult spring_path(const CondensedContact& contact,
                            const NodalLaw& law, const Flags& held,
                            const NewtonSettings& settings);

}  // namespace ffcontact
