// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/difference_loads.hpp"

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

TriangleCorners corners_of(const Mesh& mesh, int triangle) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(triangle, k);
  return corners;
}

EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges, const EdgeMoments& moments,
                                const Eigen::Ref<const Eigen::Matrix3Xd>& stress) {
  EdgeLoadsOfAll loads(12, mesh.triangles.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int edge = edges.of_triangle(k, t);
      const double eta = edges.eta(k, t);
      const Eigen::Vector4d b = eta * moments.col(edge);
      const Eigen::Vector2d side = eta * edge_vector(mesh, edges, edge);  // from vertex k+1 to k+2
      const Eigen::Vector2d half = 0.5 * traction(stress.col(t), Eigen::Vector2d(side.y(), -side.x()));
      loads.block<2, 1>(4 * k, t) = (eta > 0 ? b.head<2>() : b.tail<2>()) - half;
      loads.block<2, 1>(4 * k + 2, t) = (eta > 0 ? b.tail<2>() : b.head<2>()) - half;
    }
  return loads;
}

void take_known_tractions(const Mesh& mesh, const Edges& edges, const BoundaryTractions& boundary,
                          const Eigen::Ref<const Eigen::Matrix3Xd>& stress, EdgeLoadsOfAll& difference) {
  for (int edge = 0; edge < edges.count(); ++edge) {
    if (!edges.on_boundary(edge)) continue;
    const int t = edges.triangles(0, edge);
    int k = 0;
    while (edges.of_triangle(k, t) != edge) ++k;
    const Eigen::Vector2d side = edge_vector(mesh, edges, edge);
    const Eigen::Vector2d half = 0.5 * traction(stress.col(t), Eigen::Vector2d(side.y(), -side.x()));
    for (int end = 0; end < 2; ++end)
      for (int c = 0; c < 2; ++c)
        if (boundary.known(c, edge)) difference(4 * k + 2 * end + c, t) = boundary.moments(2 * end + c, edge) - half[c];
  }
}

}  // namespace ffcontact
