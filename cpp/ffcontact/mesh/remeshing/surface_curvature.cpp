// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/surface_curvature.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

VectorXd surface_curvature(const SolidMesh& mesh, const Facets<3>& faces,
                           const SurfaceModel& model) {
  const DividingFaces& dividing = model.dividing;
  const SurfacePatches& patches = model.patches;
  VectorXd curvature = VectorXd::Zero(mesh.vertices.cols());
  for (const DividingEdge& edge : dividing_edges(faces, dividing)) {
    if (edge.faces.size() != 2) continue;
    const int a = edge.faces[0], b = edge.faces[1];
    if (patches.surface[a] != patches.surface[b] ||
        patches.flat[patches.surface[a]])
      continue;
    const Vector3d m = facet_normal(mesh, faces, dividing.face[a]),
                   n = facet_normal(mesh, faces, dividing.face[b]);
    const double angle = 2 * std::atan2((m - n).norm(), (m + n).norm());
    const double length = (mesh.vertices.col(edge.vertices[1]) -
                           mesh.vertices.col(edge.vertices[0]))
                              .norm();
    const double height = (facet_measure(mesh, faces, dividing.face[a]) +
                           facet_measure(mesh, faces, dividing.face[b])) /
                          length;
    for (const int v : edge.vertices)
      curvature[v] =
          std::max(curvature[v], std::min(angle, M_PI - angle) / height);
  }
  return curvature;
}

}  // namespace ffcontact
