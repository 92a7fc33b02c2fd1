// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Moments of the given tractions and of those that the springs answer u_h with [d^2 x
/// SimplexMesh::boundary].
/// @param body  SolvedBody<2> or SolvedBody<3>
template <int d, class Body>
FacetColumns<d> boundary_moments(const SimplexMesh<d>& mesh, const Body& body) {
  return with_springs<d>(
      body.neumann, spring_moments<d>(mesh, body.springs, body.displacement));
}

/// Loads on supports are felt by nothing.
template <int d, class Body>
bool has_loads(const Topology<d>& topology, const Flags& prescribed,
               const Body& body) {
  const FacetTractions<d> carried =
      given_tractions<d>(topology.mesh, topology.facets, prescribed,
                         boundary_moments<d>(topology.mesh, body));
  return !carried.moments.isZero(0) || !body.body_loads.isZero(0);
}

}  // namespace ffcontact
