// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/estimate/solid_estimate.hpp"

namespace ffcontact {

/// Why the pair of an estimate is not admissible, one sentence without a full stop:
/// penetration above 1e-12, tractions outside of the cone by more than 1e-12, stresses out
/// of equilibrium by more than 1e-10. Nothing if it is.
/// @param deepest  where u_hat penetrates most
std::string reason_against(const Estimate& estimate, Construction construction,
                           const Vector2d& deepest);
std::string reason_against(const SolidEstimate& estimate,
                           const Vector3d& deepest);

}  // namespace ffcontact
