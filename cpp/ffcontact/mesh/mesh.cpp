// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/mesh.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

Vector2d turned_left(const Vector2d& v) { return {-v.y(), v.x()}; }

void require_indices(const char* what, const Ref<const MatrixXi>& vertices, int count) {
  for (Index c = 0; c < vertices.cols(); ++c)
    for (Index k = 0; k < vertices.rows(); ++k)
      if (vertices(k, c) < 0 || vertices(k, c) >= count)
        refuse(what, " ", c, " names vertex ", vertices(k, c), " of a mesh with ", count,
               " vertices");
}

}  // namespace

double signed_area(const Mesh& mesh, int triangle) {
  const Vector2d a = mesh.corner(triangle, 1) - mesh.corner(triangle, 0);
  const Vector2d b = mesh.corner(triangle, 2) - mesh.corner(triangle, 0);
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

Matrix<double, 2, 3> hat_gradients(const Mesh& mesh, int triangle) {
  Matrix<double, 2, 3> gradients;
  for (int k = 0; k < 3; ++k)
    gradients.col(k) = turned_left(mesh.corner(triangle, (k + 2) % 3) -
                                   mesh.corner(triangle, (k + 1) % 3));
  return gradients / (2 * signed_area(mesh, triangle));
}

void require_valid(const Mesh& mesh) {
  if (mesh.cell_count() == 0) refuse("the mesh has no triangles");
  if (!mesh.vertices.allFinite())
    refuse("the mesh has a vertex whose coordinates are not finite");
  require_size("boundary_label", mesh.boundary_label.size(), mesh.boundary.cols());
  require_indices("triangle", mesh.cells, mesh.vertex_count());
  require_indices("boundary edge", mesh.boundary, mesh.vertex_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    if (!(signed_area(mesh, t) > 0))
      refuse("triangle ", t, " has the area ", signed_area(mesh, t), ", not positive");
}

}  // namespace ffcontact
