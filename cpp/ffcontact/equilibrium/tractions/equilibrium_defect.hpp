// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

namespace ffcontact {

/// How far a stress that is linear on the subtriangles is from statically admissible
/// (2.2), measured on its point values:
///     h |div sigma + f|                    in each subtriangle, h = the triangle's area over its longest side: the traction on
///                                          that side that would balance it, whatever the triangle's shape
///     |jump of sigma n|                    across inner edges of the triangles and across mesh edges, at both ends
///     |sigma n - F|                        for the known components on the boundary, at both ends
/// each relative to the largest traction sigma n on any edge, or to a least scale where
/// all tractions are below it.
struct EquilibriumDefect {
  double divergence = 0;
  double jump = 0;
  double boundary = 0;
  double largest() const { return std::max({divergence, jump, boundary}); }
};

/// @param stress      corner values per triangle [MPa]
/// @param body_loads  int f phi_i per triangle; f is the field constant on the
///                    subtriangles that has these moments
/// @param least_scale  [MPa]
/// @throws std::invalid_argument  if sizes differ
EquilibriumDefect equilibrium_defect(const Mesh& mesh, const Edges& edges,
                                     const std::vector<CompositeStress>& stress,
                                     const BodyLoadsOfAll& body_loads,
                                     const BoundaryTractions& boundary,
                                     double least_scale = 0);

}  // namespace ffcontact
