// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// Is there an admissible displacement at the nodes that supports hold? Where free vertices
/// are beside those of the other body that supports hold, a node counts as inside of it only
/// if it is whatever these do between the held ones.
/// @param held  of surface_trace [3 p]
/// @throws std::invalid_argument  if prescribed dofs hold a vertex inside the foundation, or
///                                a bonded one off what it faces
void require_feasible(const SolidMesh& mesh, const ContactSurface& surface,
                      const ContactLaw<3>& law, const ElasticSystem& system,
                      const Flags& held);

}  // namespace ffcontact
