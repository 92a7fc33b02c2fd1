// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/facets.hpp"

namespace ffcontact {

/// How far a stress that is linear on the subcells is from statically admissible (2.2),
/// measured on its point values:
///     h |div sigma + f|    in each subcell, h = the cell's volume over its largest facet: the traction on that facet that
///                          would balance it, whatever the cell's shape
///     |jump of sigma n|    across the inner facets of the cells, and to the tractions with the given moments on their outer
///                          facets, which both cells beside a facet have in common
///     |t - F|              of these tractions t to the known ones on the boundary
/// at the corners.
struct EquilibriumDefect {
  double divergence = 0;
  double jump = 0;
  double boundary = 0;

  double largest() const { return std::max({divergence, jump, boundary}); }
  /// All of it as part of a stress.
  EquilibriumDefect relative_to(double scale) const {
    return {divergence / scale, jump / scale, boundary / scale};
  }
};

/// On one cell [MPa].
/// @param on_facets   moments, outward
/// @param body_loads  int f phi_i; f is the field constant on the subcells that has these
///                    moments
template <int d>
EquilibriumDefect cell_defect(const CellCorners<d>& corners,
                              const SubcellStress<d>& stress,
                              const FacetLoads<d>& on_facets,
                              const CellBodyLoads<d>& body_loads);

/// Largest difference between known boundary tractions and those of the moments [MPa].
template <int d>
double boundary_defect(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                       const FacetTractions<d>& boundary,
                       const FacetColumns<d>& moments);

/// Largest component of the traction on any facet [MPa].
template <int d>
double largest_traction(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                        const FacetColumns<d>& moments);

}  // namespace ffcontact
