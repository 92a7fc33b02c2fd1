// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

namespace ffcontact {

template <int d>
FacetLoads<d> loads_of(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetColumns<d>& moments, int cell) {
  FacetLoads<d> loads;
  for (int k = 0; k <= d; ++k) {
    const int facet = facets.of_cell(k, cell);
    for (int j = 0; j < d; ++j) {
      const int vertex = mesh.cells(vertex_of_facet<d>(k, j), cell);
      int place = 0;
      while (facets.vertices(place, facet) != vertex) ++place;
      loads.col(d * k + j) = facets.eta(k, cell) *
                             moments.col(facet).template segment<d>(d * place);
    }
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
FacetLoads<d> difference_loads(const LoadedFacets<d>& body,
                               const FacetColumns<d>& moments, int cell) {
  const FacetTopology<d>& topology = body.topology;
  FacetLoads<d> loads =
      loads_of<d>(topology.mesh, topology.facets, moments, cell);
  const CellCorners<d> vectors = facet_vectors<d>(topology.corners(cell));
  for (int k = 0; k <= d; ++k) {
    const VectorOf<d> part =
        traction(body.stress.col(cell), vectors.col(k)) / d;
    loads.template middleCols<d>(d * k).colwise() -= part;
    if (body.variation.cols() > 0)
      loads.template middleCols<d>(d * k) -= moments_of_variation<d>(
          body.variation.col(cell).reshaped(voigt_size<d>, d + 1),
          vectors.col(k), k);
  }
  return loads;
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
template FacetLoads<FFCONTACT_DIMENSION> difference_loads<FFCONTACT_DIMENSION>(
    const LoadedFacets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&, int);
template SubcellStress<FFCONTACT_DIMENSION>
difference_stress<FFCONTACT_DIMENSION>(const LoadedFacets<FFCONTACT_DIMENSION>&,
                                       const FacetColumns<FFCONTACT_DIMENSION>&,
                                       int);

}  // namespace ffcontact
