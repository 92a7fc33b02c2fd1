// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/checks/sound_problem.hpp"

#include <string>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

template <int d>
std::vector<int> touching_facets(const LineOrSurface<d>& contact) {
  std::vector<int> facets;
  for_touching_facets(contact,
                      [&](int facet, int) { facets.push_back(facet); });
  return facets;
}

/// Values that are all there are, and finite.
void require_all(const std::string& name, const Ref<const MatrixXd>& values,
                 Index columns) {
  require_size(name + "s", values.cols(), columns);
  require_finite(name, values.reshaped());
}

}  // namespace

template <int d>
void require_sound(const SolvedProblem<d>& solved,
                   const RelaxationSettings& settings) {
  const auto& [topology, contact, system, body] = solved;
  const SimplexMesh<d>& mesh = topology.mesh;
  const Index dofs = mesh.vertices.size();
  require_elliptic(body.hooke, mesh.cell_count());
  require_size("A", system.dof_count(), dofs);
  require_size("u", body.displacement.size(), dofs);
  require_finite("u", body.displacement);
  require_all(d == 2 ? "contact pressure" : "contact force", body.multipliers,
              contact.node_count());
  require_all("body load", body.body_loads, mesh.cell_count());
  require_valid(body.initial, mesh.cell_count());
  require_valid<d>(mesh, body.springs);
  require_no_springs_on<d>(topology.facets, touching_facets<d>(contact),
                           body.springs);
  require_valid(body.law, contact);
  if (body.tool && d == 3) refuse("a tool is a foundation of plane bodies");
  if (body.tool && contact.against_a_body())
    refuse("a tool is a rigid foundation, but the contact line faces a body");
  require_valid(settings);
}

template void require_sound(const SolvedProblem<FFCONTACT_DIMENSION>&,
                            const RelaxationSettings&);

}  // namespace ffcontact
