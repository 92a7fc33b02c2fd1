// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"

/// What makes a stress that is linear on the subcells statically admissible, for any values
/// at their corners.
namespace ffcontact {

/// div sigma in each subcell [N/mm^d].
template <int d>
CellBodyLoads<d> divergences(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress);

/// Jumps of sigma n across the inner facets [MPa]: column d e + c for the facet of the e-th
/// d - 1 vertices (0, 1, 2, or 01, 02, 03, 12, 13, 23) and G, at these and at G.
template <int d>
using InnerJumps = Matrix<double, d, d * d*(d + 1) / 2>;
template <int d>
InnerJumps<d> inner_jumps(const CellCorners<d>& corners,
                          const SubcellStress<d>& stress);

/// Moments of the tractions on the outer facets.
template <int d>
FacetLoads<d> facet_loads_of(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress);

/// The constant values of f on the subcells [N/mm^d], one column each, for body loads
/// int f phi_i.
template <int d>
CellBodyLoads<d> body_force_of(const CellBodyLoads<d>& body_loads,
                               double volume);

/// All of it on one cell as equations of tractions:
///     matrix * (values at the corners of the subcells) = right * (facet loads, body loads),
/// both column-major. Divergences are times the d-th root of the volume, moments over the
/// measure of their facet.
template <int d>
struct StressConditions {
  MatrixXd matrix, right;
  explicit StressConditions(const CellCorners<d>& corners);
};

}  // namespace ffcontact
