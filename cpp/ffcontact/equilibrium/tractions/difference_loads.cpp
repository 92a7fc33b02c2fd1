// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/difference_loads.hpp"

#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

TriangleCorners corners_of(const Mesh& mesh, int triangle) {
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = mesh.corner(triangle, k);
  return corners;
}

Vector2d centroid_of(const Mesh& mesh, int triangle) {
  return (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) +
          mesh.corner(triangle, 2)) /
         3;
}

namespace {

/// Moments of the tractions of sigma on one side of a triangle, from vertex k+1 to k+2.
Vector4d moments_of_stress(const Mesh& mesh, const LinearStresses& stresses,
                           int t, int k) {
  const TriangleCorners corners = corners_of(mesh, t);
  if (stresses.varies())
    return edge_loads(corners, stresses.at_vertices(t)).segment<4>(4 * k);
  const Vector2d normal = turned_right(side_of(corners, k));
  const Vector2d half = 0.5 * traction(stresses.mean.col(t), normal);
  return half.replicate<2, 1>();
}

/// The loads of that side.
Vector4d loads_of_side(const Mesh& mesh, const Edges& edges, int t, int k,
                       const Vector4d& moments,
                       const LinearStresses& stresses) {
  return moments_of_side(edges, k, t, moments) -
         moments_of_stress(mesh, stresses, t, k);
}

}  // namespace

EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges,
                                const EdgeMoments& moments,
                                const LinearStresses& stresses) {
  EdgeLoadsOfAll loads(12, mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k)
      loads.block<4, 1>(4 * k, t) = loads_of_side(
          mesh, edges, t, k, moments.col(edges.of_cell(k, t)), stresses);
  return loads;
}

int side_number(const Edges& edges, int edge, int triangle) {
  int k = 0;
  while (edges.of_cell(k, triangle) != edge) ++k;
  return k;
}

}  // namespace ffcontact
