// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// Pressures [MPa] that stand for nodal forces F [N/mm], the multipliers of M''_h. There
/// are two:
///     p_i = F_i / len_i,  len_i = int psi_i:   in the cone where F is, with the same resultant; what a contact pressure looks like
///     lambda_h = M^-1 F [CHH01, 3.1]:          the density with the loads F; alternates, and is tensile at open nodes

/// len_i = int psi_i, the length of the line that belongs to each node [mm, p].
VectorXd nodal_lengths(const ContactLine& line);

/// p_i = F_i / len_i [2 x p].
Matrix2Xd lumped_pressures(const ContactLine& line,
                           const Ref<const Matrix2Xd>& force);

/// p_i = F_i / A_i of nodal forces on a surface [MPa, 3 x p].
inline Matrix3Xd lumped_pressures(const ContactSurface& surface,
                                  const Ref<const Matrix3Xd>& force) {
  return force * surface.area.cwiseInverse().asDiagonal();
}

/// F_i = len_i p_i [2 x p].
Matrix2Xd lumped_forces(const ContactLine& line,
                        const Ref<const Matrix2Xd>& pressure);

/// The forces F_i = int lambda_h psi_i of a density with these nodal values [2 x p].
Matrix2Xd forces_of(const ContactLine& line,
                    const Ref<const Matrix2Xd>& density);

/// lambda_h with M lambda_h = F on the rows whose forces load a body [2 x p]. On
/// held_rows F is not read:
/// lambda_t = 0 at a vertex that may move along n (symmetry demands it); lambda_n, and
/// both at a clamped vertex, are continued from the next node of the line.
/// @param prescribed  1 where the dof is prescribed [2 * vertices]
Matrix2Xd consistent_pressures(const ContactLine& line, const Flags& prescribed,
                               const Ref<const Matrix2Xd>& force);

/// p_i = F_i / len_i on the rows whose forces load a body, on the others 0 or continued
/// as above [2 x p].
Matrix2Xd lumped_pressures(const ContactLine& line, const Flags& prescribed,
                           const Ref<const Matrix2Xd>& force);

/// lambda_h of the nodal pressures p that a script knows: p itself for M'_h,
/// consistent_pressures of F_i = len_i p_i for M''_h.
Matrix2Xd multiplier_density(const ContactLine& line, Multiplier multiplier,
                             const Flags& prescribed,
                             const Ref<const Matrix2Xd>& pressure);

/// Row 2 i + c (0 normal, 1 tangential) from which the multiplier of each row is
/// continued where nothing determines it, or -1: it is 0 there [2 p].
std::vector<int> continued_rows(const ContactLine& line,
                                const Flags& prescribed);

}  // namespace ffcontact
