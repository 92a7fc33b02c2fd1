// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

namespace ffcontact {

template <int d>
FacetLoads<d> loads_of(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetColumns<d>& moments, int cell) {
  FacetLoads<d> loads;
  for (int k = 0; k <= d; ++k) {
    const int facet = facets.of_cell(k, cell);
    const double eta = facets.eta(k, cell);
    for (int j = 0; j < d; ++j)
      loads.col(d * k + j) =
          eta * moments.col(facet).template segment<d>(
                    d * place_on_own<d>(mesh, facets, cell, k, j));
  }
  return loads;
}

template <int d>
FacetLoads<d> difference_loads(const LoadedFacets<d>& body,
                               const FacetColumns<d>& moments, int cell) {
  return loads_of(body.topology, moments, cell) -
         loads_of_stress(body.topology.corners(cell),
                         body.stress.at_vertices(cell));
}

template <int d>
SubcellStress<d> difference_stress(const LoadedFacets<d>& body,
                                   const FacetColumns<d>& moments, int cell) {
  return composite_stress(body.topology.corners(cell),
                          difference_loads(body, moments, cell),
                          loads_in_cell<d>(body.body_loads, cell));
}

template FacetLoads<FFCONTACT_DIMENSION> loads_of<FFCONTACT_DIMENSION>(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&, int);
template FacetLoads<FFCONTACT_DIMENSION> difference_loads<FFCONTACT_DIMENSION>(
    const LoadedFacets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&, int);
template SubcellStress<FFCONTACT_DIMENSION>
difference_stress<FFCONTACT_DIMENSION>(const LoadedFacets<FFCONTACT_DIMENSION>&,
                                       const FacetColumns<FFCONTACT_DIMENSION>&,
                                       int);

}  // namespace ffcontact
