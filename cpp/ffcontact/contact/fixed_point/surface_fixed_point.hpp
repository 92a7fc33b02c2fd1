// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/fixed_point/fixed_point.hpp"

namespace ffcontact {

/// Coulomb's law on a surface as a fixed point over Tresca's problems, as fixed_point on
/// a line; each of them is solved by surface_newton from the states of the last, or by
/// raised_friction.
FixedPointResult surface_fixed_point(const CondensedContact& contact,
                                     const NodalLaw& law, const Flags& held,
                                     ContactStates state,
                                     const NewtonSettings& settings = {});

}  // namespace ffcontact
