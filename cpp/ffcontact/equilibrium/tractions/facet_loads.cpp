// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

namespace ffcontact {

template <int d>
FacetLoads<d> loads_of(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetColumns<d>& moments, int cell) {
  FacetLoads<d> loads;
  for (int k = 0; k <= d; ++k) {
    const int facet = facets.of_cell(k, cell);
    for (int j = 0; j < d; ++j)
      loads.col(d * k + j) = facets.eta(k, cell) *
                             moments.col(facet).template segment<d>(
                                 d * place_on_own<d>(mesh, facets, cell, k, j));
  }
  return loads;
}

namespace {

/// The moments on facet k of stresses with these values at the vertices.
/// @param vector  A n of the facet
template <int d>
MatrixOf<d> moments_of_variation(
    const Matrix<double, voigt_size<d>, d + 1>& at_vertices,
    const VectorOf<d>& vector, int k) {
  MatrixOf<d> tractions;  // times A
  for (int j = 0; j < d; ++j)
    tractions.col(j) =
        traction(at_vertices.col(vertex_of_facet<d>(k, j)), vector);
  return facet_moments_of<d>(tractions, 1);
}

}  // namespace

template <int d>
FacetLoads<d> loads_of_stress(
    const CellCorners<d>& corners,
    const Matrix<double, voigt_size<d>, Dynamic>& mean,
    const StressVariation<d>& variation, int cell) {
  FacetLoads<d> loads;
  const CellCorners<d> vectors = facet_vectors<d>(corners);
  for (int k = 0; k <= d; ++k) {
    auto of_facet = loads.template middleCols<d>(d * k);
    const VectorOf<d> part = traction(mean.col(cell), vectors.col(k)) / d;
    of_facet.colwise() = part;
    if (variation.cols() > 0)
      of_facet += moments_of_variation<d>(
          variation.col(cell).reshaped(voigt_size<d>, d + 1), vectors.col(k),
          k);
  }
  return loads;
}

template <int d>
FacetLoads<d> difference_loads(const LoadedFacets<d>& body,
                               const FacetColumns<d>& moments, int cell) {
  const auto& [mesh, facets, ridges] = body.topology;
  return loads_of<d>(mesh, facets, moments, cell) -
         loads_of_stress<d>(body.topology.corners(cell), body.stress,
                            body.variation, cell);
}

template <int d>
SubcellStress<d> difference_stress(const LoadedFacets<d>& body,
                                   const FacetColumns<d>& moments, int cell) {
  return composite_stress<d>(body.topology.corners(cell),
                             difference_loads<d>(body, moments, cell),
                             body.body_loads.col(cell).reshaped(d, d + 1));
}

template FacetLoads<FFCONTACT_DIMENSION> loads_of<FFCONTACT_DIMENSION>(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&, int);
template FacetLoads<FFCONTACT_DIMENSION> loads_of_stress<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const Matrix<double, voigt_size<FFCONTACT_DIMENSION>, Dynamic>&,
    const StressVariation<FFCONTACT_DIMENSION>&, int);
template FacetLoads<FFCONTACT_DIMENSION> difference_loads<FFCONTACT_DIMENSION>(
    const LoadedFacets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&, int);
template SubcellStress<FFCONTACT_DIMENSION>
difference_stress<FFCONTACT_DIMENSION>(const LoadedFacets<FFCONTACT_DIMENSION>&,
                                       const FacetColumns<FFCONTACT_DIMENSION>&,
                                       int);

}  // namespace ffcontact
