// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/sound_solid.hpp"

#include "ffcontact/estimate/checks/sound_body.hpp"

namespace ffcontact {

void require_sound(const SolvedSolidProblem& solved,
                   const RelaxationSettings& settings) {
  const auto& [topology, surface, system, body] = solved;
  require_sound_body(solved, surface.node_count(), "contact force", body.force);
  require_valid(body.initial, topology.mesh.cell_count());
  require_valid(body.law, surface);
  require_valid(settings);
}

}  // namespace ffcontact
