// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"

namespace ffcontact {

/// The cones of tractions at the nodes [MPa, p].
template <int d>
std::vector<FrictionCone> law_cones(const ContactLaw<d>& law);

/// The cones of the multipliers: bounds of pressures are those of tractions, of nodal forces
/// M k along lines [N/mm], and A_i k_i on surfaces [N].
template <int d>
NodalLaw nodal_law(const ContactLaw<d>& law, const LineOrSurface<d>& where);

}  // namespace ffcontact
