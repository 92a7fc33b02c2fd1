// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/facet_term.hpp"

namespace ffcontact {

/// An edge whose springs answer what star relaxation asks of them.
struct FreeSpring {
  int edge;           ///< of the mesh
  Matrix2d answers;   ///< projector on the directions that are free
  SpringError error;  ///< by the changes of the edge's moments
};

/// Spring tractions that take part in the relaxation: on edges without contact, in the
/// directions that springs answer and no support does. Where springs are inclined to a
/// support on the same edge they stay as they are.
/// @param boundary      all given and spring tractions
/// @param displacement  u_hat
/// @param tractions     moments of the springs' tractions [4 x Mesh::boundary]
std::vector<FreeSpring> free_springs(const Mesh& mesh, const Edges& edges,
                                     const BoundarySprings& springs,
                                     const BoundaryTractions& boundary,
                                     const std::vector<int>& contact_edge,
                                     const Ref<const VectorXd>& displacement,
                                     const Matrix4Xd& tractions);

/// The boundary tractions without those that the springs may change.
BoundaryTractions released(BoundaryTractions boundary,
                           const std::vector<FreeSpring>& springs);

/// The springs' error by the moments of their edges.
std::vector<FacetTerm<2>> terms_of(const std::vector<FreeSpring>& springs);

/// Adds to the springs' tractions what the relaxation has changed them by, in the
/// directions that are free.
/// @param boundary   tractions before
/// @param moments    of sigma_hat on all edges
/// @param tractions  [4 x Mesh::boundary]
void add_spring_changes(const Mesh& mesh, const Edges& edges,
                        const std::vector<FreeSpring>& springs,
                        const BoundaryTractions& boundary,
                        const EdgeMoments& moments, Matrix4Xd& tractions);

}  // namespace ffcontact
