// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// r_hat, and face tractions in equilibrium with it on every tetrahedron.
struct FirstSurfaceTractions {
  Matrix3Xd contact;    ///< r_hat at the nodes [MPa, 3 x p]
  FaceMoments springs;  ///< moments of the springs' tractions [9 x boundary]
  FaceMoments
      beside;  ///< of given tractions on the faces of the surface [9 x m]
  FaceTractions boundary;
  FaceMoments moments;
};

/// What the boundary carries with these tractions of contact and springs.
FaceTractions boundary_with(const SolvedProblem<3>& solved,
                            const FaceMoments& springs,
                            const Ref<const Matrix3Xd>& contact);

/// Tractions in the cone are not those that u_h was computed with: one back-substitution
/// gives the small displacement whose stresses make up for the difference, and one or two
/// more its rounding (Rebalancing); springs answer it.
/// @param stress        of u_h per tetrahedron [MPa]
/// @param stress_terms  largest_stress_terms of u_h [MPa]
/// @throws std::invalid_argument  if loads and stresses do not balance each other, with
///                                the cause, or where no tractions in the cone hold the
///                                body
FirstSurfaceTractions first_tractions(const SolvedProblem<3>& solved,
                                      const CellStresses<3>& stress,
                                      double stress_terms);

}  // namespace ffcontact
