// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/joined_mesh.hpp"

#include <algorithm>

#include "ffcontact/mesh/near_origin.hpp"

namespace ffcontact {

namespace {

/// First place of each block and the total at the end.
template <int dim, class Count>
std::vector<int> offsets(const std::vector<SimplexMesh<dim>>& bodies,
                         Count&& count) {
  std::vector<int> first(1, 0);
  for (const SimplexMesh<dim>& body : bodies)
    first.push_back(first.back() + static_cast<int>(count(body)));
  return first;
}

template <int dim>
int span_of_labels(const std::vector<SimplexMesh<dim>>& bodies) {
  int lowest = 0, highest = 0;
  for (const SimplexMesh<dim>& body : bodies)
    if (body.boundary_label.size() > 0) {
      lowest = std::min(lowest, body.boundary_label.minCoeff());
      highest = std::max(highest, body.boundary_label.maxCoeff());
    }
  return highest - lowest + 1;
}

template <int dim>
void make_room(JoinedBodies<dim>& joined) {
  const int facets = joined.first_boundary.back();
  joined.mesh.vertices.resize(dim, joined.first_vertex.back());
  joined.mesh.cells.resize(dim + 1, joined.first_cell.back());
  joined.mesh.boundary.resize(dim, facets);
  joined.mesh.boundary_label.resize(facets);
}

/// Where each body begins, and room for all of them.
template <int dim>
JoinedBodies<dim> room_for(const std::vector<SimplexMesh<dim>>& bodies) {
  using Body = SimplexMesh<dim>;
  JoinedBodies<dim> joined;
  joined.first_vertex =
      offsets(bodies, [](const Body& m) { return m.vertices.cols(); });
  joined.first_cell =
      offsets(bodies, [](const Body& m) { return m.cells.cols(); });
  joined.first_boundary =
      offsets(bodies, [](const Body& m) { return m.boundary.cols(); });
  joined.label_stride = span_of_labels(bodies);
  make_room(joined);
  return joined;
}

template <int dim>
void put(const SimplexMesh<dim>& body, int k, JoinedBodies<dim>& joined) {
  const int v = joined.first_vertex[k], c = joined.first_cell[k],
            b = joined.first_boundary[k];
  const Index facets = body.boundary.cols();
  SimplexMesh<dim>& mesh = joined.mesh;
  mesh.vertices.middleCols(v, body.vertices.cols()) = body.vertices;
  mesh.cells.middleCols(c, body.cells.cols()) = body.cells.array() + v;
  mesh.boundary.middleCols(b, facets) = body.boundary.array() + v;
  mesh.boundary_label.segment(b, facets) =
      body.boundary_label.array() + joined.label(k, 0);
}

}  // namespace

template <int dim>
JoinedBodies<dim> joined_mesh(const std::vector<SimplexMesh<dim>>& bodies) {
  JoinedBodies<dim> joined = room_for(bodies);
  for (int k = 0; k < joined.body_count(); ++k) put(bodies[k], k, joined);
  take_from_near_origin(joined.mesh);
  return joined;
}

template JoinedBodies<FFCONTACT_DIMENSION> joined_mesh(
    const std::vector<SimplexMesh<FFCONTACT_DIMENSION>>&);

}  // namespace ffcontact
