// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/airy_function.hpp"
#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// The corrections of the edge tractions at one vertex i that keep every triangle in
/// equilibrium are Airy functions (AirySpace) carried by the star of i: unknowns are its
/// own three, then that of each spoke; all else of A is zero.
inline int star_unknowns(const Stars& stars, int vertex) {
  return 3 + stars.spoke_count(vertex);
}

/// Adds the corrections y of a star.
template <class Vector>
void add_corrections(const AirySpace& space, const Stars& stars, int vertex,
                     const Vector& y, VectorXd& airy) {
  const int* spoke = stars.spoke.data() + stars.spoke_start[vertex];
  for (int c = 0; c < 3; ++c) airy[space.of_vertex(vertex) + c] += y[c];
  for (int k = 0; k < stars.spoke_count(vertex); ++k)
    airy[space.of_edge(spoke[k])] += y[3 + k];
}

/// The tractions on the spokes of a star.
class StarCorrections {
 public:
  StarCorrections(const AirySpace& space, const Stars& stars, int vertex);

  int vertex() const { return vertex_; }
  int unknowns() const { return 3 + spoke_count(); }
  int spoke_count() const { return static_cast<int>(moments_.size()); }
  int spoke(int k) const { return spoke_[k]; }

  /// Moments (b_i, b_j) of spoke k, i -> j, for (A / l0, A_x, A_y, dA/dn of this spoke),
  /// normal to the right of i -> j.
  const Matrix4d& moments(int k) const { return moments_[k]; }
  /// Places of these four unknowns among all.
  std::array<int, 4> columns_of_spoke(int k) const { return {0, 1, 2, 3 + k}; }

 private:
  int vertex_;
  const int* spoke_;
  std::vector<Matrix4d> moments_;
};

}  // namespace ffcontact
