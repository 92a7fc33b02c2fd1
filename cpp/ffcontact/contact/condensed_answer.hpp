// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/fixed_point/fixed_point.hpp"

namespace ffcontact {

/// The factor that the settings bring, or that of the system.
std::shared_ptr<const CondensedStiffness> prepared_stiffness(
    const std::vector<int>& contact_dofs, const ElasticSystem& system,
    const ContactSettings& settings, Precision precision = Precision::full);

/// The condensed problem by the chosen solver, from the chosen states. Newton; where it
/// does not converge, the convex minimum, or with Coulomb's law the fixed point helped by
/// Newton.
FixedPointResult condensed_answer(const CondensedContact& contact,
                                  const NodalLaw& law,
                                  const ContactSettings& settings);

}  // namespace ffcontact
