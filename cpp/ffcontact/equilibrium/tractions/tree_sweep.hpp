// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

/// Facet moments that balance every cell to rounding, from those that balance it nearly, as
/// where stresses are those of an inexact solution: with the residual rho = loads - K u
/// cells are out of balance by about |rho| / (d + 1).
///
/// What a cell lacks is the wrench about the centroid of a facet of it (r numbers),
///     w = sum of (f_i, (x_i - x_F) x f_i / h_F)   over the body loads and the moments on its facets, outward.
/// Cells are in trees (CellTrees) whose roots are the boundary facets on which supports answer in all directions. From the
/// ends of a tree to its root each adds what those below it have handed to it, and hands the sum through its facet towards
/// the root by the least moments that have it,
///     b -= eta W'(W W')^-1 w                      (wrench_moments, eta = +1 for cells(0)).
/// As wrenches are handed on, not what rounding of b leaves of them, cells lack no more than rounding of their own. Given
/// tractions stay as they are, to the last digit.
///
/// A connected part without such a root has a resultant, the sum of what its cells lack. The
/// supports that answer in some directions, and springs, take of it what they can: forces
///     f_i = A / d P (a + c x (x_i - x_0))         at the vertices of each such facet of measure A,
/// P the projector on these directions, which on a plane of symmetry leaves the force along its normal and the moments
/// across; (a, c) is the least in the sense of least squares. What no support takes is the resultant of given loads, 0
/// but for rounding where K is singular along it. It stays, as a body force a + c x (x - x_0) that all cells lack.
///
/// The same bits for any number of threads.
/// @param body_loads  int f phi_i per cell
/// @param boundary    with the tractions of springs among what is known
/// @param springs     that may answer where no part of the boundary is supported in all directions
template <int d>
void sweep_to_roots(const FacetTopology<d>& topology,
                    const BodyLoadsOfCells<d>& body_loads,
                    const FacetTractions<d>& boundary,
                    const std::vector<FreeSpring<d>>& springs,
                    FacetColumns<d>& moments);

}  // namespace ffcontact
