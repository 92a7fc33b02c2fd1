// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// A body as facet moments are relaxed for |sigma_hat - sigma|^2. All of it belongs to
/// someone else.
template <int d>
struct LoadedFacets {
  FacetTopology<d> topology;
  const HookeTensors<d>& hooke;
  const FacetTractions<d>& boundary;
  const BodyLoadsOfCells<d>& body_loads;  ///< of sigma_hat - sigma
  const LinearStresses<d>& stress;        ///< sigma
  std::vector<FacetTerm<d>> terms = {};
};

/// The moments on the facets of a cell, outward.
template <int d>
FacetLoads<d> loads_of(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetColumns<d>& moments, int cell);

template <int d>
FacetLoads<d> loads_of(const FacetTopology<d>& topology,
                       const FacetColumns<d>& moments, int cell) {
  return loads_of(topology.mesh, topology.facets, moments, cell);
}

/// The loads of sigma_hat - sigma on one cell's facets. With the body loads they are in
/// equilibrium when sigma_hat is.
template <int d>
FacetLoads<d> difference_loads(const LoadedFacets<d>& body,
                               const FacetColumns<d>& moments, int cell);

/// sigma_hat - sigma on one cell [MPa].
template <int d>
SubcellStress<d> difference_stress(const LoadedFacets<d>& body,
                                   const FacetColumns<d>& moments, int cell);

}  // namespace ffcontact
