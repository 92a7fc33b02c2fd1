// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/joined_mesh.hpp"

#include <algorithm>

#include "ffcontact/mesh/near_origin.hpp"

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

void make_room(JoinedMesh& joined) {
  const int edges = joined.first_boundary.back();
  joined.mesh.vertices.resize(2, joined.first_vertex.back());
  joined.mesh.cells.resize(3, joined.first_triangle.back());
  joined.mesh.boundary.resize(2, edges);
  joined.mesh.boundary_label.resize(edges);
}

/// Where each body begins, and room for all of them.
JoinedMesh room_for(const std::vector<Mesh>& bodies) {
  JoinedMesh joined;
  joined.first_vertex =
      offsets(bodies, [](const Mesh& m) { return m.vertices.cols(); });
  joined.first_triangle =
      offsets(bodies, [](const Mesh& m) { return m.cells.cols(); });
  joined.first_boundary =
      offsets(bodies, [](const Mesh& m) { return m.boundary.cols(); });
  joined.label_stride = span_of_labels(bodies);
  make_room(joined);
  return joined;
}

void put(const Mesh& body, int k, JoinedMesh& joined) {
  const int v = joined.first_vertex[k];
  const int t = joined.first_triangle[k];
  const int b = joined.first_boundary[k];
  const Index edges = body.boundary.cols();
  Mesh& mesh = joined.mesh;
  mesh.vertices.middleCols(v, body.vertices.cols()) = body.vertices;
  mesh.cells.middleCols(t, body.cells.cols()) = body.cells.array() + v;
  mesh.boundary.middleCols(b, edges) = body.boundary.array() + v;
  mesh.boundary_label.segment(b, edges) =
      body.boundary_label.array() + joined.label(k, 0);
}

}  // namespace

JoinedMesh joined_mesh(const std::vector<Mesh>& bodies) {
  JoinedMesh joined = room_for(bodies);
  for (int k = 0; k < joined.body_count(); ++k) put(bodies[k], k, joined);
  take_from_near_origin(joined.mesh);
  return joined;
}

}  // namespace ffcontact
