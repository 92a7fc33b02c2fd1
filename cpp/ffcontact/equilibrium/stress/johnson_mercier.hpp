// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"

namespace ffcontact {

/// The stress that is linear on the d + 1 subcells of a triangle or a tetrahedron [Johnson,
/// Mercier 1978; CHH01, 4.2.2, analytical; and in space], for given loads.
///
/// With continuous tractions on the inner facets, div sigma + f = 0 in each subcell (f
/// constant in each) and linear tractions F on the outer facets, the 27 or 96 coefficients
/// are fixed by the loads of the cell, if these are in equilibrium. Loads out of it are
/// balanced in the sense of least squares on the reference cell: the caller's equilibrium
/// is the stress's.
///
/// Computed once on the reference cell and carried over by Piola's map x = B xi + x_0:
///     sigma = B s B' / det B,   forces = B (forces)_ref,
/// which keeps symmetry, equilibrium and facet forces. Of the rounding of a stress it makes
/// as much more as the square of the cell's longest edge over its least height, so that on
/// thin cells (1 : 57 in the plane, 1 : 100 in space) the conditions are solved directly,
/// which takes 30 microseconds a triangle and 0.6 milliseconds a tetrahedron.
template <int d>
SubcellStress<d> composite_stress(const CellCorners<d>& corners,
                                  const FacetLoads<d>& on_facets,
                                  const CellBodyLoads<d>& body_loads);

/// int f phi_i for the one f that balances the forces on the facets.
template <int d>
CellBodyLoads<d> balancing_body_loads(const FacetLoads<d>& on_facets);

/// T with sigma = T s / det B in Voigt order, for Piola's map sigma = B s B' / det B.
template <int d>
VoigtMatrix<d> piola_voigt(const MatrixOf<d>& B);

/// int sigma : C^-1 sigma over one cell, exactly [N mm, per unit thickness in the plane].
/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
template <int d>
double energy(const CellCorners<d>& corners, const VoigtMatrix<d>& compliance,
              const SubcellStress<d>& stress);

}  // namespace ffcontact
