// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/interface/pairing/common_refinement.hpp"

namespace ffcontact {

/// What the old boundary carries when the cut one carries the given tractions: the
/// moments of a part of an old edge with the hat functions of its ends are
///     B_first = (1 - p) b_first + (1 - q) b_second,   B_second = p b_first + q b_second,   p, q the places of the part's ends,
/// summed over the parts. They are exact, also where the density is linear on each part
/// only.
/// @param boundary  on the old mesh; its contact edges are overwritten
/// @param cut       on the refinement
BoundaryTractions tractions_of_parts(const Edges& old_edges,
                                     const CommonRefinement& refinement,
                                     const BoundaryTractions& cut,
                                     BoundaryTractions boundary);

/// Edge tractions in equilibrium on the refinement from those on the old mesh.
///
/// Edges that were not cut keep their moments, cut ones take those of `cut`. On the edges
/// inside a fan the moments nearest to those of the old triangle's stress balance force
/// and moment of every triangle; they exist because the old triangle is balanced.
/// @param old_moments  in equilibrium with tractions_of_parts
/// @param old_stress   of the old triangles [MPa]
/// @param body_loads   int f phi_i on the refinement, with the same sums as on the old
///                     mesh
EdgeMoments refined_moments(const Edges& old_edges,
                            const CommonRefinement& refinement,
                            const EdgeMoments& old_moments,
                            const Ref<const Matrix3Xd>& old_stress,
                            const BodyLoadsOfCells<2>& body_loads,
                            const BoundaryTractions& cut);

/// The triangles of each old triangle that was cut.
std::map<int, std::vector<int>> fans_of(const CommonRefinement& refinement,
                                        int old_triangles);

/// Body loads int f phi_i of the refinement: f is the linear function on each old
/// triangle that has the old loads.
BodyLoadsOfCells<2> refined_body_loads(const Mesh& old_mesh,
                                       const CommonRefinement& refinement,
                                       const BodyLoadsOfCells<2>& old_loads);

/// Moments of boundary tractions, linear on the old edges, at the ends of the columns of
/// Mesh::boundary [4 x boundary].
Matrix4Xd refined_boundary_moments(const Mesh& old_mesh,
                                   const CommonRefinement& refinement,
                                   const Ref<const Matrix4Xd>& old_moments);

}  // namespace ffcontact
