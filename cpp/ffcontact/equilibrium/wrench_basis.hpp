// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "ffcontact/equilibrium/face_energy.hpp"
#include "ffcontact/mesh/solid_topology.hpp"

namespace ffcontact {

using Matrix6d = Matrix<double, 6, 6>;
using Vector6d = Matrix<double, 6, 1>;
using Vector9d = Matrix<double, 9, 1>;

/// The nine moments b of a face by its wrench w and the forces y of three bars:
///     b = V (w, y),   w = (sum of b_i, sum of (x_i - x_F) x b_i / h_F),   x_F the centroid, h_F = A^(1/2),
/// all in N. Bar k pushes the ends of the side opposite to vertex k apart. The wrench
/// without bars has the least moments, W'(W W')^-1 w. A tetrahedron stays balanced if and
/// only if the wrenches of its faces, seen outward, add to zero.
Matrix9d wrench_basis(const Matrix3d& face_corners);

/// x -> a x x
Matrix3d cross_product_with(const Vector3d& a);

/// The wrench that all faces around an edge of length h_e and middle x_e carry, seen
/// across them in the direction in which they turn about it:
///     w_e = (f, m / h_e), m about x_e,   w_F = s_F Shift w_e,   m_F = m - (x_F - x_e) x f,
/// with s_F = 1 where the normal of the face follows the right-hand turn about the edge.
struct WrenchShift {
  Vector3d arm;  ///< (x_F - x_e) / h_F
  double ratio;  ///< h_e / h_F
  double sign;   ///< s_F

  /// s_F Shift w
  Vector6d times(const Vector6d& w) const {
    const Vector3d f = w.head<3>(), m = w.tail<3>();
    Vector6d shifted;
    shifted << sign * f, sign * (ratio * m - arm.cross(f));
    return shifted;
  }
  /// s_F Shift' w
  Vector6d transposed_times(const Vector6d& w) const {
    const Vector3d f = w.head<3>(), m = w.tail<3>();
    Vector6d shifted;
    shifted << sign * (f + arm.cross(m)), sign * ratio * m;
    return shifted;
  }
  Matrix6d matrix() const;  ///< s_F Shift
};
WrenchShift wrench_shift(const SolidTopology& topology, int face, int edge);

/// The wrench on a face d of a tetrahedron that balances one on its face k:
///     w_d = s Shift w_k,   m_d = (h_k m_k - (x_d - x_k) x f_k) / h_d,   s = -eta_k eta_d.
/// @param k, d  0 to 3
WrenchShift balancing_shift(const SolidTopology& topology, int cell, int k,
                            int d);

/// The columns of face_energy on a tetrahedron for its four faces' (w, y), as these are
/// stored: of the face's own normal, in the order of its vertices.
std::array<Matrix9d, 4> wrench_bases(const SolidTopology& topology, int cell);

}  // namespace ffcontact
