// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/contact_law.hpp"

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
  return interleaved(densities.normal.col(edge), densities.tangential.col(edge));
}
inline void set_end_values(ContactDensities& densities, int edge, const Vector4d& r) {
  densities.normal.col(edge) = Vector2d(r[0], r[2]);
  densities.tangential.col(edge) = Vector2d(r[1], r[3]);
}

/// The continuous densities with the given nodal values (lambda_n, lambda_t) [2 x p].
ContactDensities edge_densities(const ContactLine& line,
                                const Ref<const Matrix2Xd>& pressure);

/// The law on one contact edge as linear conditions C r >= d on the end values r =
/// (r_n,i, r_t,i, r_n,j, r_t,j).
///
/// With the lower bound m of the coefficient (least_coefficient), linear between m_i and
/// m_j, and p = -r_n:
///     r_n <= 0 and |r_t| <= m p at both ends,    |r_t,i + r_t,j| <= m_i p_j + m_j p_i                     (Coulomb)
///     r_n <= 0 and |r_t| <= m at both ends                                                                (Tresca)
/// and with a shear limit |r_t| <= k at both ends, k its lower bound (least_shear_limit),
/// beside Coulomb's. Coulomb's last one, for which m may not be the same at both ends, is
/// the middle Bernstein coefficient of the quadratics m p -+ r_t: with it the edge is in
/// the cone all along. Without friction, m = 0 at an end, r_t = 0 at that end is no
/// inequality: it is not in C.
struct EdgeCone {
  static constexpr Index most_rows = 12;
  Eigen::Array2<bool> frictionless;  ///< per end
  Matrix<double, Dynamic, 4> C;
  VectorXd d;
};
EdgeCone edge_cone(const ContactLine& line, const ContactLaw& law, int edge);

/// Cuts off the rounding of end values r that are in the cone of their edge but for it.
Vector4d clamped_to_cone(const ContactLine& line, const ContactLaw& law, int edge,
                         const Vector4d& r);

/// Cone correction: bring equilibrated contact densities into Coulomb's cone.
///
/// On a straight contact edge with ends i, j the densities r_n (compression < 0) and r_t
/// are linear. For constant mu Coulomb's condition  |r_t| <= c,  c = -mu r_n >= 0,  holds
/// on the whole edge if and only if it holds at both ends. The correction is the smallest
/// shift d, opposite at the two ends, that achieves it [CHH01, (4.1)]:
///     |r_t,i - d| <= c_i,   |r_t,j + d| <= c_j.
/// The added density has no resultant and, being tangential, no moment, so the triangle
/// stays in equilibrium. A shift exists if and only if r_n <= 0 at both ends and |r_t,i +
/// r_t,j| <= c_i + c_j; where mu varies the sum, which no shift changes, must be within
/// EdgeCone's last condition, too. Otherwise the edge is left alone and listed.
struct ConeCorrection {
  ContactDensities densities;  ///< normal part unchanged
  /// d, one per edge [MPa]; 0 where none is needed or none exists
  VectorXd shift;
  std::vector<int> uncorrected;  ///< edges without a shift, ascending

  int corrected_count() const { return static_cast<int>((shift.array() != 0).count()); }
};

/// @throws std::invalid_argument  if sizes differ, a value is not finite, or the given
///                                directions of a line turn along an edge
ConeCorrection correct_to_cone(const ContactLine& line, const ContactLaw& law,
                               const ContactDensities& densities);

/// Largest of r_n and |r_t| - c along all edges, with c from the lower bound of the
/// coefficient, relative to the largest traction; 0 inside the cone.
double cone_defect(const ContactLine& line, const ContactLaw& law,
                   const ContactDensities& densities);

}  // namespace ffcontact
