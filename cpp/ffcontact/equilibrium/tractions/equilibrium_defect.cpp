// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"

#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Largest difference of the tractions on the outer facets to those with given moments.
template <int d>
double outer_jump(const CellCorners<d>& vectors, const SubcellStress<d>& stress,
                  const FacetLoads<d>& on_facets) {
  double largest = 0;
  for (int k = 0; k <= d; ++k) {
    const VectorOf<d> n = vectors.col(k).normalized();
    MatrixOf<d> jump = facet_density<d>(on_facets.template middleCols<d>(d * k),
                                        vectors.col(k).norm());
    for (int j = 0; j < d; ++j)
      jump.col(j) -= traction(stress.col((d + 1) * k + j), n);
    largest = std::max(largest, max_norm(jump));
  }
  return largest;
}

template <int d>
MatrixOf<d> density_on(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       int facet, const FacetColumns<d>& moments) {
  return facet_density<d>(moments.col(facet).reshaped(d, d),
                          facet_measure(mesh, facets, facet));
}

}  // namespace

template <int d>
EquilibriumDefect cell_defect(const CellCorners<d>& corners,
                              const SubcellStress<d>& stress,
                              const FacetLoads<d>& on_facets,
                              const CellBodyLoads<d>& body_loads) {
  const CellCorners<d> vectors = facet_vectors(corners);
  const double volume = volume_of(corners),
               height = volume / vectors.colwise().norm().maxCoeff();
  EquilibriumDefect defect;
  defect.divergence = height * max_norm(divergences(corners, stress) +
                                        body_force_of<d>(body_loads, volume));
  defect.jump = std::max(max_norm(inner_jumps(corners, stress)),
                         outer_jump<d>(vectors, stress, on_facets));
  return defect;
}

template <int d>
double boundary_defect(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetTractions<d>& boundary,
                       const FacetColumns<d>& moments) {
  double largest = 0;
  for (int f = 0; f < facets.count(); ++f) {
    if (!boundary.known.col(f).any()) continue;
    const MatrixOf<d> off = density_on(mesh, facets, f, moments) -
                            density_on(mesh, facets, f, boundary.moments);
    for (int c = 0; c < d; ++c)
      if (boundary.known(c, f))
        largest = std::max(largest, max_norm(off.row(c)));
  }
  return largest;
}

template <int d>
double largest_traction(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                        const FacetColumns<d>& moments) {
  double largest = 0;
#pragma omp parallel for reduction(max : largest)
  for (int f = 0; f < facets.count(); ++f)
    largest = std::max(largest, max_norm(density_on(mesh, facets, f, moments)));
  return largest;
}

template EquilibriumDefect cell_defect<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const SubcellStress<FFCONTACT_DIMENSION>&,
    const FacetLoads<FFCONTACT_DIMENSION>&,
    const CellBodyLoads<FFCONTACT_DIMENSION>&);
template double boundary_defect<FFCONTACT_DIMENSION>(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&);
template double largest_traction<FFCONTACT_DIMENSION>(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
