// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/boundary_tractions.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"
#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// Given tractions that do not balance the stresses at a vertex.
struct Imbalance : std::invalid_argument {
  Imbalance(const std::string& sentence, int vertex, int component)
      : std::invalid_argument(sentence), vertex(vertex), component(component) {}
  int vertex, component;
};

/// Edge tractions in equilibrium with the body forces on every triangle, built star by
/// star [CHH01, 4.2.2, first step].
///
/// For vertex i and each triangle E of its star the moments b of the two edges at i
/// balance the finite element stress,
///     sum of eta b = int_E (sigma_h : eps(phi_i e) - f . phi_i e) = |E| sigma_h grad phi_i - int_E f phi_i,
/// which makes every triangle balanced in force and moment, since rigid motions are
/// combinations of phi_i e. Around the star this is a chain: one free parameter per
/// component, taken by least squares to the mean of the stresses on both sides, unless a
/// boundary edge of the star has its moment given. The last equation holds because u_h is
/// in equilibrium at i.
/// @param stress      sigma_h per triangle, Voigt [MPa]
/// @param body_loads  int_E f phi_i at the three vertices of each triangle [N/mm, 6 x
///                    triangles]
struct NodalEquilibrium {
  EdgeMoments moments;
  /// forces that would balance what is left over at each vertex [N/mm, 2 x vertices]
  Matrix2Xd missing;
  double scale;  ///< largest moment [N/mm]
};
NodalEquilibrium nodal_equilibrium(const Mesh& mesh, const Edges& edges,
                                   const Stars& stars, const Ref<const Matrix3Xd>& stress,
                                   const BodyLoadsOfAll& body_loads,
                                   const BoundaryTractions& boundary);

/// @param least_scale  moments below this are rounding: what is left over is judged
///                     against the largest moment, or this [N/mm]
/// @throws Imbalance  if the given tractions do not balance the stresses at a vertex
///                    (other loads than those u_h was computed
///                    with, or a point support with a reaction), naming the vertex
void require_balanced(const Mesh& mesh, const NodalEquilibrium& equilibrium,
                      double least_scale = 0);

/// The moments alone, for given tractions that balance the stresses.
/// @throws Imbalance  as require_balanced
EdgeMoments equilibrated_moments(const Mesh& mesh, const Edges& edges, const Stars& stars,
                                 const Ref<const Matrix3Xd>& stress,
                                 const BodyLoadsOfAll& body_loads,
                                 const BoundaryTractions& boundary);

}  // namespace ffcontact
