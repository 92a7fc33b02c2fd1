// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

namespace ffcontact {

/// Facet tractions in equilibrium with the body forces on every cell, built vertex by
/// vertex [CHH01, 4.2.2, first step].
///
/// For vertex i and each cell T of its star the moments b of the d facets at i balance the
/// finite element stress,
///     sum of eta b = |T| sigma_h grad phi_i - int_T f phi_i,
/// which makes every cell balanced in force and moment, since rigid motions are
/// combinations of phi_i e. Per component this is a graph: cells are its nodes, facets its
/// arcs; in the plane it is a chain or a ring. Of the solutions the one nearest to z0 =
/// A/d (mean of both stresses) n in the norm with weights 1/w is taken. In the plane w =
/// A^2 / (areas beside the edge), so that the norm is that of the stresses that forces on
/// edges cause: with w = 1 forces on the short edges of stretched triangles would be as
/// large as those on long ones. In space w = A:
///     z = z0 + W N' (N W N')^+ (q - N z0),   N the incidence of the arcs not known, W = diag(w).
/// Where no free boundary facet ends a star, the equations fit one another if nothing is
/// missing at i (NodalResidual); what is missing all its cells share.
/// @param stress      sigma_h per cell, Voigt [MPa]
/// @param body_loads  int_T f phi_i at the vertices of each cell [N, N/mm in the plane]
template <int d>
FacetColumns<d> equilibrated_moments(const Topology<d>& topology,
                                     const CellStresses<d>& stress,
                                     const BodyLoadsOfCells<d>& body_loads,
                                     const FacetTractions<d>& boundary);

}  // namespace ffcontact
