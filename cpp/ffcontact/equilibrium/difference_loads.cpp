// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/difference_loads.hpp"

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

TriangleCorners corners_of(const Mesh& mesh, int triangle) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(triangle, k);
  return corners;
}

EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges,
                                const EdgeMoments& moments,
                                const Ref<const Matrix3Xd>& stress) {
  EdgeLoadsOfAll loads(12, mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int edge = edges.of_cell(k, t);
      const double eta = edges.eta(k, t);
      const Vector4d b = eta * moments.col(edge);
      // from vertex k+1 to k+2
      const Vector2d side = eta * edge_vector(mesh, edges, edge);
      const Vector2d half = 0.5 * traction(stress.col(t), Vector2d(side.y(), -side.x()));
      loads.block<2, 1>(4 * k, t) = (eta > 0 ? b.head<2>() : b.tail<2>()) - half;
      loads.block<2, 1>(4 * k + 2, t) = (eta > 0 ? b.tail<2>() : b.head<2>()) - half;
    }
  return loads;
}

}  // namespace ffcontact
