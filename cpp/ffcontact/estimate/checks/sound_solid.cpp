// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/sound_solid.hpp"

#include "ffcontact/estimate/checks/sound_body.hpp"

namespace ffcontact {

void require_sound(const SolvedSolidProblem& solved,
                   const RelaxationSettings& settings) {
  const auto& [topology, surface, system, body] = solved;
  require_sound_body(solved, surface.node_count(), "contact force", body.force);
  require_valid<3>(topology.mesh, body.springs);
  std::vector<int> contact(surface.face.begin(), surface.face.end());
  for (const FacingPolygon& polygon : surface.polygons)
    contact.push_back(polygon.opposite_face);
  require_no_springs_on<3>(topology.facets, contact, body.springs);
  require_valid(body.law, surface);
  require_valid(settings);
}

}  // namespace ffcontact
