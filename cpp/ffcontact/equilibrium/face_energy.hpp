// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/johnson_mercier.hpp"

namespace ffcontact {

using Matrix9d = Matrix<double, 9, 9>;
using FaceForm = Matrix<double, 36, 36>;

/// The energy of a tetrahedron's composite stress as a form in the loads on its faces,
/// body loads being those that balance them (balancing_body_loads):
///     int sigma : C^-1 sigma = x' H x,   loads of face k (FaceLoads, column-major) = basis[k] x_k.
///
/// With Piola's map sigma = T s / det B and s = L b_ref the reference tetrahedron has 21
/// matrices P_ab, one for each pair of Voigt components, and
///     H_ref = sum of M_ab P_ab,   M = T' C^-1 T / det B,   b = B b_ref:
/// 21 x 666 products, and 2 x 36 x 36 x 9 for the basis.
/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
FaceForm face_energy(const TetrahedronCorners& corners,
                     const Matrix<double, 6, 6>& compliance,
                     const std::array<Matrix9d, 4>& basis);

/// The same in single precision, for what only steers.
Matrix<float, 36, 36> rough_face_energy(const TetrahedronCorners& corners,
                                        const Matrix<double, 6, 6>& compliance,
                                        const std::array<Matrix9d, 4>& basis);

/// g with int sigma : C^-1 tau = g' x for the stress tau of these loads x.
/// @param stress  sigma
Matrix<double, 36, 1> face_slope(const TetrahedronCorners& corners,
                                 const Matrix<double, 6, 6>& compliance,
                                 const SolidStress& stress,
                                 const std::array<Matrix9d, 4>& basis);

}  // namespace ffcontact
