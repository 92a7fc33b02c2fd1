// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/multigrid/shared_vertex.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"

namespace ffcontact {

/// What the states of a SharedVertex make of the forces F = K u - b on its y, of the motion
/// v~ of its rows and of the forces z of those that couple what it faces:
///     P = of_force F + of_v v~ + of_z z + given,
///     0 = z_of_P P + z_of_v v~ - z_value for z, in forces.
/// Own rows without a layer whose condition is v = 0 hold y, and take what is left of F:
///     P_k + sum_d E_dk P_d = F_k,   d: rows that are not own.
/// The others have the equations of their states (SurfaceEquations) with
///     v = v~ + (gamma + 1 / s) P,
/// where s is 1e4 of the bodies' stiffness and v~ less 1 / s of the last P: where nodes of a
/// vertex share a force in more than one way, they keep the way they had, as in
/// solve_surface_step, and v tends to 0 by a factor of 1e4 a step. Rows that couple have
/// these equations for their P = z, where v is in them: multigrid does not know the springs
/// that they would be.
struct SharedResponse {
  MatrixXd of_force;        ///< [r x 3]
  MatrixXd of_v;            ///< [r x r]
  MatrixXd of_z;            ///< [r x q]
  VectorXd given;           ///< [r]
  MatrixXd z_of_P, z_of_v;  ///< 0 where P is no z [q x r]
  VectorXd z_value;         ///< [q]

  /// Of no forces.
  explicit SharedResponse(const SharedVertex& shared);
};

/// 1 / s of the rows.
VectorXd softness(const SharedVertex& shared);

/// Does a row hold its y?
bool holds(const SharedVertex& shared, const SurfaceEquations& equations,
           int place);

/// @param friction  false: without what P_n makes of P_t
SharedResponse shared_response(const SharedVertex& shared,
                               const SurfaceEquations& equations,
                               bool friction = true);

}  // namespace ffcontact
