// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/energy/ridge_lines.hpp"

namespace ffcontact {

/// The vertices of a share, each in one line.
///
/// Where triangles are stretched by an aspect q the stars of vertices at the ends of their
/// short edges depend on each other q^4 times as much as others do, and stars that are
/// solved one by one need about q^2 steps until a change has gone along the line. The
/// measure of an edge is what couples its ends in Laplace's equation,
///     k = (cot a + cot b) / 2,   a, b the angles opposite to it,
/// about q on short edges, 1/q on long ones, 0.6 among equilateral triangles; on the
/// boundary there is one angle. Edges with k >= 2 make lines, the strongest first, and of
/// equal ones that of the lower number, as long as only neighbours in a line have cells in
/// common.
///
/// A line does not leave the cells of its share: the stars at its border, which several
/// solve, are solved by each for themselves. Lines depend on the shares.
RidgeLines short_edge_lines(const FacetTopology<2>& topology,
                            const FacetShare& share);

}  // namespace ffcontact
