// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// CellBodyLoads per cell, column-major.
template <int d>
using BodyLoadsOfCells = Matrix<double, d*(d + 1), Dynamic>;

/// What linear stresses have at the vertices of each cell beyond their mean, column-major
/// [MPa].
template <int d>
using StressVariation = Matrix<double, voigt_size<d>*(d + 1), Dynamic>;
template <int d>
inline const StressVariation<d> no_variation;

/// A body as facet moments are relaxed for |sigma_hat - sigma|^2. All of it belongs to
/// someone else.
template <int d>
struct LoadedFacets {
  FacetTopology<d> topology;
  const HookeTensors<d>& hooke;
  const FacetTractions<d>& boundary;
  const BodyLoadsOfCells<d>& body_loads;
  /// sigma, its mean per cell [MPa]
  const Matrix<double, voigt_size<d>, Dynamic>& stress;
  /// what its values at the vertices of a cell have beyond the mean; without columns:
  /// nothing
  const StressVariation<d>& variation = no_variation<d>;
  std::vector<FacetTerm<d>> terms = {};
};

/// The moments on the facets of a cell, outward.
template <int d>
FacetLoads<d> loads_of(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetColumns<d>& moments, int cell);

/// The loads of a linear stress on one cell's facets.
/// @param mean       per cell [MPa]
/// @param variation  without columns: none
template <int d>
FacetLoads<d> loads_of_stress(
    const CellCorners<d>& corners,
    const Matrix<double, voigt_size<d>, Dynamic>& mean,
    const StressVariation<d>& variation, int cell);

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
