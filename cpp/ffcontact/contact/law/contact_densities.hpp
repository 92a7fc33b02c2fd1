// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Contact tractions that are linear on each contact edge, by their values at its first
/// and second node. They may jump from edge to edge.
struct ContactDensities {
  /// r_n at the two ends of each edge [MPa], compression < 0 [2 x m]
  Matrix2Xd normal;
  Matrix2Xd tangential;  ///< r_t likewise
};

/// (a_i, b_i, a_j, b_j) from the values of two components at the ends i, j of an edge.
inline Vector4d interleaved(const Vector2d& a, const Vector2d& b) {
  return {a[0], b[0], a[1], b[1]};
}

/// r = (r_n,i, r_t,i, r_n,j, r_t,j) on one edge.
inline Vector4d end_values(const ContactDensities& densities, int edge) {
  return interleaved(densities.normal.col(edge),
                     densities.tangential.col(edge));
}
inline void set_end_values(ContactDensities& densities, int edge,
                           const Vector4d& r) {
  densities.normal.col(edge) = Vector2d(r[0], r[2]);
  densities.tangential.col(edge) = Vector2d(r[1], r[3]);
}

/// The continuous densities with the given nodal values (lambda_n, lambda_t) [2 x p].
ContactDensities edge_densities(const ContactLine& line,
                                const Ref<const Matrix2Xd>& pressure);

/// Largest |r_n| or |r_t| at an end of an edge [MPa]; 0 without edges.
double largest_traction(const ContactDensities& densities);

}  // namespace ffcontact
