// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"

namespace ffcontact {

/// The step s at which stresses under s l are twice those under the loads, where contact
/// holds what it touches, or six times on hat functions alone. Farther on rounding counts in
/// bounds of l.
/// @param stiffness  factor of the system, or null
/// @param l          on free dofs
/// @param stress     energy norm under the loads, |sigma_h|
double longest_step(const ElasticSystem& system,
                    const CondensedStiffness* stiffness, const VectorXd& l,
                    double stress);

}  // namespace ffcontact
