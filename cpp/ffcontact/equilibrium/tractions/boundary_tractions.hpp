// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// Moments of linear edge tractions, int F phi at the first and at the second vertex of
/// each mesh edge, where F = sigma n with the edge's normal (outward on the boundary):
/// one column (b_first, b_second) per edge [N/mm].
using EdgeMoments = FacetColumns<2>;

/// The moments of the same traction seen along the edge the other way round, with the
/// normal turned too.
Vector4d reversed(const Vector4d& moments);

using BoundaryTractions = FacetTractions<2>;

/// The given and the contact tractions.
/// @param line     where it faces whole edges of another body, these carry the opposite
///                 forces
/// @param contact  densities on the contact edges
/// @throws std::invalid_argument  as given_tractions
BoundaryTractions boundary_tractions(const Mesh& mesh, const Edges& edges,
                                     const Flags& prescribed,
                                     const Ref<const Matrix4Xd>& neumann,
                                     const ContactLine& line,
                                     const ContactDensities& contact);

/// The mesh edge that faces a contact edge as a whole, or -1.
inline int facing_edge(const ContactLine& line, int contact_edge) {
  return line.against_a_body() ? line.opposite_edge[contact_edge] : -1;
}

/// Number on the contact line of each mesh edge, that of an opposite body which a contact
/// edge faces included, or -1.
std::vector<int> contact_edge_numbers(const ContactLine& line,
                                      const Edges& edges);

/// What end values r = (r_n,i, r_t,i, r_n,j, r_t,j) on a contact edge make of its moments
/// int r phi at i and at j, Cartesian [4 x 4, mm]. Along the edge
///     r(s) = r_n(s) n(s) + r_t(s) t(s)
/// with components and directions that are linear between the nodes, n not of unit length: as
/// t(s) is orthogonal to n(s) and as long, r(s) is in Coulomb's cone about n(s) where (r_n,
/// r_t)(s) is in it, whatever n turns by. Blocks int phi_k phi_i (n, t)(s); of the products of
/// three hats int phi_k phi_i phi_j is l/4 where all are one, and l/12 otherwise.
Matrix4d moments_of_ends(const ContactLine& line, int contact_edge);

/// int r phi at the first and the second node of a contact edge, Cartesian [N/mm].
Vector4d contact_moments(const ContactLine& line,
                         const ContactDensities& densities, int contact_edge);

}  // namespace ffcontact
