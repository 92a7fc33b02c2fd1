// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "support/solids.hpp"

namespace ffcontact::test {

/// Values at the vertices of the `ratio` times finer brick of a field on brick(cells,
/// ...), exactly: Kuhn's tetrahedra of the fine bricks lie in those of the coarse ones.
inline VectorXd on_finer_brick(const VectorXd& coarse, const Vector3i& cells,
                               int ratio) {
  const auto number = [](const Vector3i& at, const Vector3i& of) {
    return (at.z() * (of.y() + 1) + at.y()) * (of.x() + 1) + at.x();
  };
  const Vector3i fine_cells = ratio * cells;
  VectorXd fine(3 * (fine_cells.array() + 1).prod());
  for (int k = 0; k <= fine_cells.z(); ++k)
    for (int j = 0; j <= fine_cells.y(); ++j)
      for (int i = 0; i <= fine_cells.x(); ++i) {
        const Vector3i at(i, j, k),
            corner = (at / ratio).cwiseMin(cells - Vector3i::Ones());
        const Vector3d share = (at - ratio * corner).cast<double>() /
                               ratio;  // in the coarse brick
        std::array<int, 3> axes{0, 1,
                                2};  // of the path through the tetrahedron
        std::stable_sort(axes.begin(), axes.end(),
                         [&](int a, int b) { return share[a] > share[b]; });
        Vector3i vertex = corner;
        const auto value = [&] {
          return Vector3d(coarse.segment<3>(3 * number(vertex, cells)));
        };
        Vector3d u = (1 - share[axes[0]]) * value();
        for (int step = 0; step < 3; ++step) {
          vertex += Vector3i::Unit(axes[step]);
          const double next = step < 2 ? share[axes[step + 1]] : 0;
          u += (share[axes[step]] - next) * value();
        }
        fine.segment<3>(3 * number(at, fine_cells)) = u;
      }
  return fine;
}

}  // namespace ffcontact::test
