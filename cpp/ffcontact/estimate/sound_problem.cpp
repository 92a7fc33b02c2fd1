// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/sound_problem.hpp"

#include <string>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/relaxation_progress.hpp"

namespace ffcontact {

namespace {

void require_valid(const LinearStresses& initial, int triangles) {
  if (initial.empty()) return;
  require_size("initial stress", initial.mean.cols(), triangles);
  for (int t = 0; t < triangles; ++t)
    if (!initial.at_vertices(t).allFinite())
      refuse("the initial strain or stress on triangle ", t,
             " is not a finite number");
}

/// What bodies in the plane and solids have in common.
/// @param multiplier  what the contact carries at its nodes, of the name given
template <class Solved>
void require_sound_body(const Solved& solved, Index nodes,
                        const std::string& name,
                        const Ref<const MatrixXd>& multiplier) {
  const auto& mesh = solved.topology.mesh;
  const auto& body = solved.body;
  const Index dofs = mesh.vertices.size();
  require_elliptic(body.hooke, mesh.cell_count());
  require_size("A", solved.system.dof_count(), dofs);
  require_size("u", body.displacement.size(), dofs);
  require_finite("u", body.displacement);
  require_size(name + "s", multiplier.cols(), nodes);
  require_finite(name, multiplier.reshaped());
  require_size("body loads", body.body_loads.cols(), mesh.cell_count());
  require_finite("body load", body.body_loads.reshaped());
}

}  // namespace

void require_sound(const SolvedProblem& solved,
                   const EstimateSettings& settings) {
  const auto& [topology, line, system, body] = solved;
  const Mesh& mesh = topology.mesh;
  require_sound_body(solved, line.node_count(), "contact pressure",
                     body.pressure);
  require_valid(body.initial, mesh.cell_count());
  require_valid(mesh, body.springs);
  require_no_springs_in_contact(topology.edges, line, body.springs);
  require_valid(body.law, line);
  if (body.tool && line.against_a_body())
    refuse("a tool is a rigid foundation, but the contact line faces a body");
  if (settings.relaxation.sweeps < 0)
    refuse("sweeps must not be negative, got ", settings.relaxation.sweeps);
  require_tightness(settings.relaxation.tightness);
}

void require_sound(const SolvedSolidProblem& solved,
                   const SolidRelaxationSettings& settings) {
  const auto& [topology, surface, system, body] = solved;
  require_sound_body(solved, surface.node_count(), "contact force", body.force);
  require_valid(body.law, surface);
  if (settings.steps && *settings.steps < 0)
    refuse("steps must not be negative, got ", *settings.steps);
  require_tightness(settings.tightness);
}

}  // namespace ffcontact
