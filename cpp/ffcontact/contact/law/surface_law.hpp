// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// The law of contact and friction on a surface, at its nodes:
///     P_n <= 0,  v_n <= 0,  P_n v_n = 0
///     |P_t| <= b,   v_t = 0 where |P_t| < b,   P_t = -b v_t / |v_t| where v_t != 0
/// for v = (u_n - gap, u_t - previous) and the nodal forces P = F that load the bodies
/// (M''_h), with b of ContactLaw and Tresca's bound and the shear limit times the area of
/// the node; |.| is Euclid's norm, the cone is a circular one.
/// v = 0 and P of any size and direction where it is bonded.
struct SurfaceLaw {
  VectorXd friction;    ///< mu >= 0 [p]
  VectorXd slip_bound;  ///< Tresca's bound [MPa, p], in place of mu; or empty
  VectorXd
      shear_limit;  ///< largest |lambda_t| of Coulomb's law [MPa, p]; or empty
  VectorXd gap;     ///< along n [mm, p]; empty for none
  Matrix2Xd previous;   ///< u_t of the load step before [mm, 2 x p]; or empty
  bool bonded = false;  ///< glued to what it faces, as of ContactLaw
  CompliantLayer layer{};  ///< in the interface
  /// (r_n, r_t1, r_t2) at the nodes that it carries, as of ContactLaw [MPa, 3 x p]; or empty
  Matrix3Xd carried{};
};

/// Contact on the far side of a layer that carries tractions, as of a line.
/// @param traction  at the nodes [MPa, 3 x p]
SurfaceLaw on_layer(SurfaceLaw law, const Ref<const Matrix3Xd>& traction);

/// @throws std::invalid_argument  if sizes differ from the surface's or a coefficient is
///                                negative or not finite
void require_valid(const SurfaceLaw& law, const ContactSurface& surface);

/// p_i = F_i / A_i of nodal forces [MPa, 3 x p].
Matrix3Xd lumped_pressures(const ContactSurface& surface,
                           const Ref<const Matrix3Xd>& force);

/// The cones of nodal forces [N].
NodalLaw nodal_law(const SurfaceLaw& law, const ContactSurface& surface);

/// The cones of tractions at the nodes [MPa, p].
std::vector<FrictionCone> law_cones(const SurfaceLaw& law,
                                    const ContactSurface& surface);

/// (u_n - gap, u_t - previous) at the nodes [3 x p] of a displacement on all dofs.
Matrix3Xd displacement_against_foundation(
    const ContactSurface& surface, const SurfaceLaw& law,
    const Ref<const VectorXd>& displacement);

/// The largest component of a displacement, gap or displacement of the load step before
/// [mm].
double largest_displacement(const SurfaceLaw& law,
                            const Ref<const VectorXd>& displacement);

/// Largest violation of the law at the nodes by P and v, rows 3 i + c [3 p], relative as
/// in law_violation of a line. Either v_t or P_t + b v_t / |v_t| must be 0: the smaller
/// one is the violation.
double surface_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                         const Ref<const VectorXd>& v, const LawScales& scales);

}  // namespace ffcontact
