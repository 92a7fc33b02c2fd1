// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/equilibrium/composite_stress.hpp"
#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// The corrections of the edge tractions at one vertex i that keep every triangle in equilibrium: stresses of Airy functions A
/// in the Hsieh-Clough-Tocher space (C1, cubic on the three subtriangles) carried by the star of i.
///
/// Unknowns: A / l0 and grad A at i, dA/dn at the middle of each spoke i -> j (n to its right); all else of A is zero. With
/// psi = (A_y, -A_x) the traction along a spoke is d psi/ds, linear in s, with the moments
///     b_i = (-5 psi_i + 4 psi_m) / 6,   b_j = (-psi_i - 4 psi_m) / 6
/// on the normal to the right of i -> j, where at the middle dA/ds = -3/2 A_i / l - 1/4 (dA/ds)_i. All unknowns are forces
/// per unit thickness [N/mm]; l0 is the mean length of the spokes.
class StarCorrections {
 public:
  StarCorrections(const Mesh& mesh, const Edges& edges, const Stars& stars, int vertex);

  int unknowns() const { return 3 + spokes_; }
  int triangle_count() const { return triangles_; }
  int spoke_count() const { return spokes_; }
  int triangle(int k) const { return triangle_[k]; }
  int spoke(int k) const { return spoke_[k]; }

  /// Moments (b_i, b_j) of spoke k for (A / l0, A_x, A_y, dA/dn of this spoke), normal to the right of i -> j.
  const Eigen::Matrix4d& moments(int k) const { return moments_[k]; }
  /// Places of these four unknowns among all.
  std::array<int, 4> columns_of_spoke(int k) const { return {0, 1, 2, 3 + k}; }

  /// Edge loads of triangle k, eight of the twelve, for (A / l0, A_x, A_y, dA/dn of its right spoke, dA/dn of its left spoke).
  Eigen::Matrix<double, 8, 5> triangle_loads(int k) const;
  /// Where those eight loads stand in EdgeLoads.
  std::array<int, 8> rows(int k) const;
  /// Places of the five unknowns of triangle k among all.
  std::array<int, 5> columns(int k) const { return {0, 1, 2, 3 + k, 3 + left_spoke(k)}; }

 private:
  int left_spoke(int k) const { return (k + 1) % spokes_; }

  int triangles_, spokes_;
  const int *triangle_, *local_, *spoke_;
  std::vector<Eigen::Matrix4d> moments_;
};

}  // namespace ffcontact
