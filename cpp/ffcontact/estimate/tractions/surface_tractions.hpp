// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"

namespace ffcontact {

/// Contact tractions r_hat on a surface (BentTraction): (r_n, r_t1, r_t2) at the nodes [MPa,
/// 3 x p]. A law linear between the nodes holds all along a face if it holds at its nodes:
/// the cones are convex.

/// (r_n, r_t1, r_t2) at the three vertices of each contact face, one column a face [MPa].
using SurfaceTractions = Matrix<double, 9, Dynamic>;

/// At the three vertices of one contact face, one column each.
inline Matrix3d of_face(const SurfaceTractions& tractions, Index m) {
  return tractions.col(m).reshaped(3, 3);
}

/// The cones of tractions at the nodes [MPa] that r_hat keeps to (bounded_friction); e pays
/// for law_cones.
std::vector<FrictionCone> traction_cones(const ContactLaw<3>& law);

/// F_i / A_i of nodal forces, in the cone where they are but for rounding. Keeps their
/// resultant on a plane; where normals turn A_i is that seen along the node's.
Matrix3Xd lumped_tractions(const ContactLaw<3>& law,
                           const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& force);

/// Where supports hold a node that touches the foundation along its normal, the forces on
/// it load nothing and are 0: there the mean of the tractions at the nodes of its faces
/// that are not held, in its own cone, as pressures go on up to a clamped edge; where all of
/// them are held, that of those which have one by now.
/// @param displacement  on all dofs [mm]
/// @param prescribed    1 where the dof is prescribed
Matrix3Xd continued_tractions(const ContactLaw<3>& law,
                              const ContactSurface& surface,
                              const VectorXd& displacement,
                              const Flags& prescribed, Matrix3Xd traction);

/// Tractions of the nodes at the vertices of each face.
SurfaceTractions tractions_by_face(const ContactSurface& surface,
                                   const Ref<const Matrix3Xd>& traction);

/// int [z_k] . r over what the surface faces [k].
/// @param motions  vertex fields z_k, linear on the faces [3 * vertices x k]
VectorXd resultants_of(const SolidMesh& mesh, const Facets<3>& faces,
                       const ContactSurface& surface,
                       const Ref<const Matrix3Xd>& traction,
                       const MatrixXd& motions);

/// The tractions in the cones nearest to given ones, min 1/2 sum of A_i |r_i - r0_i|^2,
/// with given resultants. By duality
///     r_i = Pi_i(r0_i + sum of eta_k int chi_i [z_k] / A_i),
/// where the multipliers eta minimise a convex function whose gradient is what the
/// resultants are off: Newton's method.
/// @param carries  nodes whose tractions may change [p]; all if empty
/// @return nothing if there are no such tractions
std::optional<Matrix3Xd> nearest_in_cone(
    const SolidMesh& mesh, const Facets<3>& faces,
    const ContactSurface& surface, const ContactLaw<3>& law,
    const Ref<const Matrix3Xd>& traction, const MatrixXd& motions,
    const VectorXd& resultants, const Flags& carries = {});

/// Largest of r_n and |r_t| less its bound at the nodes [MPa]; 0 in the cone.
double cone_violation(const ContactLaw<3>& law,
                      const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
