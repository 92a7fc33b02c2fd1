// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/difference_loads.hpp"

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

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

EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges,
                                const EdgeMoments& moments,
                                const LinearStresses& stresses) {
  EdgeLoadsOfAll loads(12, mesh.cells.cols());
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const FacetLoads<2> difference =
        loads_of<2>(mesh, edges, moments, t) -
        loads_of_stress<2>(corners_of(mesh, t), stresses.mean,
                           stresses.variation, t);
    loads.col(t) = difference.reshaped();
  }
  return loads;
}

}  // namespace ffcontact
