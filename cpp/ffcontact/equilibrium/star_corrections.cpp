// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_corrections.hpp"

namespace ffcontact {

namespace {

/// @param sign  +1 when the spoke runs along its edge, whose normal dA/dn counts
Matrix4d spoke_moments(const Vector2d& spoke, double l0, double sign) {
  const double length = spoke.norm();
  const Vector2d s = spoke / length, n(s.y(), -s.x());
  Matrix<double, 2, 4> gradient_i = Matrix<double, 2, 4>::Zero(), gradient_m;
  gradient_i.middleCols<2>(1).setIdentity();
  gradient_m << -1.5 * l0 / length * s, -0.25 * s * s.transpose(), sign * n;
  Matrix2d psi;  // (A_x, A_y) -> (A_y, -A_x)
  psi << 0, 1, -1, 0;
  Matrix4d moments;
  moments.topRows<2>() = psi * (-5 * gradient_i + 4 * gradient_m) / 6;
  moments.bottomRows<2>() = psi * (-gradient_i - 4 * gradient_m) / 6;
  return moments;
}

}  // namespace

StarCorrections::StarCorrections(const AirySpace& space, const Stars& stars,
                                 int vertex)
    : vertex_(vertex),
      spoke_(stars.spoke.data() + stars.spoke_start[vertex]),
      moments_(stars.spoke_count(vertex)) {
  for (int k = 0; k < spoke_count(); ++k) {
    const double sign = space.edges.vertices(0, spoke_[k]) == vertex ? 1 : -1;
    moments_[k] =
        spoke_moments(sign * edge_vector(space.mesh, space.edges, spoke_[k]),
                      space.length[vertex], sign);
  }
}

}  // namespace ffcontact
