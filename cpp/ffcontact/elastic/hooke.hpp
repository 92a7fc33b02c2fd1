// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Hooke's tensor on each triangle [MPa], in Voigt order with engineering shear:
///     (sigma_xx, sigma_yy, sigma_xy) = C (eps_xx, eps_yy, 2 eps_xy).
using Hooke = std::vector<Matrix3d>;

/// sigma = lambda tr(eps) I + 2 G eps: plane strain with Lame's constants [MPa].
Matrix3d isotropic(double lambda, double G);

/// @throws std::invalid_argument  naming the first triangle whose tensor is not finite,
///                                symmetric and positive definite
void require_elliptic(const Hooke& hooke, int triangle_count);

/// Strain of the linear displacement on one triangle, Voigt with engineering shear [-].
Vector3d strain(const Mesh& mesh, const Ref<const VectorXd>& displacement, int triangle);

/// sigma_h = C eps(u_h), one column per triangle [MPa].
Matrix3Xd stresses(const Mesh& mesh, const Hooke& hooke,
                   const Ref<const VectorXd>& displacement);

/// Traction sigma n of a Voigt stress on a normal [MPa].
inline Vector2d traction(const Vector3d& stress, const Vector2d& normal) {
  return {stress[0] * normal.x() + stress[2] * normal.y(),
          stress[2] * normal.x() + stress[1] * normal.y()};
}

}  // namespace ffcontact
