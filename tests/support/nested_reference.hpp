// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "support/estimates.hpp"

/// Errors against the solution on a nested finer mesh, in the energy norm.
namespace ffcontact::test {

/// Values at the vertices of the `ratio` times finer rectangle of a field on rectangle(nx, ny, ...), exactly: the diagonals of
/// the fine squares lie on those of the coarse ones.
inline Eigen::VectorXd on_finer_rectangle(const Eigen::VectorXd& coarse, int nx, int ny, int ratio) {
  const int fine_x = nx * ratio, fine_y = ny * ratio;
  Eigen::VectorXd fine(2 * (fine_x + 1) * (fine_y + 1));
  const auto value = [&](int i, int j) { return Eigen::Vector2d(coarse.segment<2>(2 * (j * (nx + 1) + i))); };
  for (int j = 0; j <= fine_y; ++j)
    for (int i = 0; i <= fine_x; ++i) {
      const int I = std::min(i / ratio, nx - 1), J = std::min(j / ratio, ny - 1);
      const double x = static_cast<double>(i) / ratio - I, y = static_cast<double>(j) / ratio - J;
      const Eigen::Vector2d corner = value(I, J), opposite = value(I + 1, J + 1);
      const Eigen::Vector2d other = x >= y ? value(I + 1, J) : value(I, J + 1);  // below or above the diagonal
      fine.segment<2>(2 * (j * (fine_x + 1) + i)) = x >= y
                                                        ? corner + (x - y) * (other - corner) + y * (opposite - corner)
                                                        : corner + (y - x) * (other - corner) + x * (opposite - corner);
    }
  return fine;
}

/// |v| = a(v, v)^(1/2).
inline double energy_norm(const Problem& problem, const Eigen::VectorXd& v) {
  return std::sqrt(v.dot(stiffness(problem.mesh, problem.hooke) * v));
}

}  // namespace ffcontact::test
