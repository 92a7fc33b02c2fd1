// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A quadratic vector on a triangle by its polar form in barycentric coordinates,
///     r(phi) = sum over k, l of phi_k phi_l R_kl,   R_kl = R_lk in column 3 k + l.
using QuadraticOnFace = Matrix<double, 3, 9>;

/// phi_k phi_l of places phi = P eta by eta_a eta_b [9 x 9]: R of eta is R times it.
Matrix<double, 9, 9> products_of_places(const Matrix3d& P);

/// The linear vector with these values at the corners.
QuadraticOnFace raised(const Matrix3d& corners);

inline Vector3d value_at(const QuadraticOnFace& r, const Vector3d& place) {
  return r * (place * place.transpose()).reshaped();
}

/// int phi_k phi_l phi_j over the unit of area, row 3 k + l.
const Matrix<double, 9, 3>& triple_products();
/// int phi_k phi_l phi_m phi_n likewise.
const Matrix<double, 9, 9>& fourfold_products();

}  // namespace ffcontact
