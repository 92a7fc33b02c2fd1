// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/sound_problem.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/checks/sound_body.hpp"

namespace ffcontact {

void require_sound(const SolvedProblem& solved,
                   const EstimateSettings& settings) {
  const auto& [topology, line, system, body] = solved;
  const Mesh& mesh = topology.mesh;
  require_sound_body(solved, line.node_count(), "contact pressure",
                     body.pressure);
  require_valid<2>(mesh, body.springs);
  std::vector<int> contact(line.edge.begin(), line.edge.end());
  for (const FacingPiece& piece : line.pieces)
    contact.push_back(piece.opposite_edge);
  require_no_springs_on<2>(topology.facets, contact, body.springs);
  require_valid(body.law, line);
  if (body.tool && line.against_a_body())
    refuse("a tool is a rigid foundation, but the contact line faces a body");
  require_valid(settings.relaxation);
}

}  // namespace ffcontact
