// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/joined_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

/// First place of each block and the total at the end.
template <class Count>
std::vector<int> offsets(const std::vector<Mesh>& bodies, Count&& count) {
  std::vector<int> first(1, 0);
  for (const Mesh& body : bodies)
    first.push_back(first.back() + static_cast<int>(count(body)));
  return first;
}

int span_of_labels(const std::vector<Mesh>& bodies) {
  int lowest = 0, highest = 0;
  for (const Mesh& body : bodies)
    if (body.boundary_label.size() > 0) {
      lowest = std::min(lowest, body.boundary_label.minCoeff());
      highest = std::max(highest, body.boundary_label.maxCoeff());
    }
  return highest - lowest + 1;
}

/// A multiple of a power of two well above the size of the bodies: its difference to
/// their coordinates is exact, and bodies within a few sizes of zero keep theirs.
Vector2d origin_near(const Matrix2Xd& vertices) {
  if (vertices.cols() == 0) return Vector2d::Zero();
  const Vector2d lowest = vertices.rowwise().minCoeff(),
                 highest = vertices.rowwise().maxCoeff();
  const double step = std::exp2(std::ceil(std::log2((highest - lowest).norm())) + 3);
  const Vector2d middle = 0.5 * (lowest + highest);
  if (!middle.allFinite() || !std::isnormal(step)) return Vector2d::Zero();
  return {std::rint(middle.x() / step) * step, std::rint(middle.y() / step) * step};
}

}  // namespace

JoinedMesh joined_mesh(const std::vector<Mesh>& bodies) {
  JoinedMesh joined;
  joined.first_vertex =
      offsets(bodies, [](const Mesh& body) { return body.vertices.cols(); });
  joined.first_triangle =
      offsets(bodies, [](const Mesh& body) { return body.cells.cols(); });
  joined.first_boundary =
      offsets(bodies, [](const Mesh& body) { return body.boundary.cols(); });
  joined.label_stride = span_of_labels(bodies);

  Mesh& mesh = joined.mesh;
  mesh.vertices.resize(2, joined.first_vertex.back());
  mesh.cells.resize(3, joined.first_triangle.back());
  mesh.boundary.resize(2, joined.first_boundary.back());
  mesh.boundary_label.resize(joined.first_boundary.back());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Mesh& body = bodies[k];
    const int v = joined.first_vertex[k], t = joined.first_triangle[k],
              b = joined.first_boundary[k];
    mesh.vertices.middleCols(v, body.vertices.cols()) = body.vertices;
    mesh.cells.middleCols(t, body.cells.cols()) = body.cells.array() + v;
    mesh.boundary.middleCols(b, body.boundary.cols()) = body.boundary.array() + v;
    mesh.boundary_label.segment(b, body.boundary.cols()) =
        body.boundary_label.array() + static_cast<int>(k) * joined.label_stride;
  }
  mesh.origin = origin_near(mesh.vertices);
  mesh.vertices.colwise() -= mesh.origin;
  return joined;
}

}  // namespace ffcontact
