// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/star_corrections.hpp"

namespace ffcontact {

namespace {

Eigen::Matrix4d spoke_moments(const Eigen::Vector2d& spoke, double l0) {
  const double length = spoke.norm();
  const Eigen::Vector2d s = spoke / length, n(s.y(), -s.x());
  Eigen::Matrix<double, 2, 4> gradient_i = Eigen::Matrix<double, 2, 4>::Zero(), gradient_m;
  gradient_i.middleCols<2>(1).setIdentity();
  gradient_m << -1.5 * l0 / length * s, -0.25 * s * s.transpose(), n;
  Eigen::Matrix2d psi;  // (A_x, A_y) -> (A_y, -A_x)
  psi << 0, 1, -1, 0;
  Eigen::Matrix4d moments;
  moments.topRows<2>() = psi * (-5 * gradient_i + 4 * gradient_m) / 6;
  moments.bottomRows<2>() = psi * (-gradient_i - 4 * gradient_m) / 6;
  return moments;
}

}  // namespace

StarCorrections::StarCorrections(const Mesh& mesh, const Edges& edges, const Stars& stars, int vertex)
    : triangles_(stars.triangle_count(vertex)),
      spokes_(stars.spoke_count(vertex)),
      triangle_(stars.triangle.data() + stars.triangle_start[vertex]),
      local_(stars.local.data() + stars.triangle_start[vertex]),
      spoke_(stars.spoke.data() + stars.spoke_start[vertex]),
      moments_(spokes_) {
  const auto vector = [&](int k) -> Eigen::Vector2d {
    const double sign = edges.vertices(0, spoke_[k]) == vertex ? 1 : -1;
    return sign * edge_vector(mesh, edges, spoke_[k]);
  };
  double l0 = 0;
  for (int k = 0; k < spokes_; ++k) l0 += vector(k).norm() / spokes_;
  for (int k = 0; k < spokes_; ++k) moments_[k] = spoke_moments(vector(k), l0);
}

Eigen::Matrix<double, 8, 5> StarCorrections::triangle_loads(int k) const {
  const Eigen::Matrix4d &right = moments_[k], &left = moments_[left_spoke(k)];
  Eigen::Matrix<double, 8, 5> loads;
  loads << right, Eigen::Vector4d::Zero(), -left.leftCols<3>(), Eigen::Vector4d::Zero(), -left.rightCols<1>();
  return loads;
}

std::array<int, 8> StarCorrections::rows(int k) const {
  // The right spoke is the edge opposite to local + 2, from vertex i to local + 1: moments in order i, j. The left spoke is
  // the edge opposite to local + 1, from local + 2 to i: moments in order j, i.
  const int right = 4 * ((local_[k] + 2) % 3), left = 4 * ((local_[k] + 1) % 3);
  return {right, right + 1, right + 2, right + 3, left + 2, left + 3, left, left + 1};
}

}  // namespace ffcontact
