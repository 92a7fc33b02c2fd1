// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/surface_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// Can contact on a surface balance the loads on the unheld rigid motions, as on a line?
/// The cones are taken a thousandth wider, with 64 sides: what they cannot balance no
/// force in the cones can.
/// @throws NoEquilibrium  naming a motion that it cannot balance
void require_balance(const SolidMesh& mesh, const ContactSurface& surface,
                     const SurfaceLaw& law, const ElasticSystem& system);

}  // namespace ffcontact
