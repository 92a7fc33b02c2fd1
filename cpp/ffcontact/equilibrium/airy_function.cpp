// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_function.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

/// l0
VectorXd mean_edge_lengths(const Mesh& mesh, const Edges& edges) {
  VectorXd length = VectorXd::Zero(mesh.vertex_count());
  VectorXi count = VectorXi::Zero(mesh.vertex_count());
  for (int edge = 0; edge < edges.count(); ++edge)
    for (const int v : edges.vertices.col(edge)) {
      length[v] += edge_vector(mesh, edges, edge).norm();
      ++count[v];
    }
  return length.array() / count.array().max(1).cast<double>();
}

/// An Airy function by its unknowns.
struct AiryField {
  const AirySpace& space;
  const VectorXd& unknowns;

  double value(int vertex) const {
    return space.length[vertex] * unknowns[space.of_vertex(vertex)];
  }
  Vector2d gradient(int vertex) const {
    return unknowns.segment<2>(space.of_vertex(vertex) + 1);
  }

  /// dA/ds in the middle of an edge i -> j with the unit tangent s and the length l.
  double slope_in_middle(const Vector2i& ends, const Vector2d& s,
                         double l) const {
    const int i = ends[0], j = ends[1];
    return 1.5 * (value(j) - value(i)) / l -
           0.25 * s.dot(gradient(i) + gradient(j));
  }

  Vector2d gradient_in_middle(int edge) const {
    const Vector2d side = edge_vector(space.mesh, space.edges, edge);
    const double l = side.norm();
    const Vector2d s = side / l;
    const double along = slope_in_middle(space.edges.vertices.col(edge), s, l);
    return along * s + unknowns[space.of_edge(edge)] * turned_right(s);
  }

  Vector4d moments(int edge) const {
    const Vector2i ends = space.edges.vertices.col(edge);
    return moments_of_gradients(gradient(ends[0]), gradient_in_middle(edge),
                                gradient(ends[1]));
  }

  EdgeLoads loads(int t) const {
    EdgeLoads loads;
    for (int k = 0; k < 3; ++k)
      loads.segment<4>(4 * k) = moments_of_side(
          space.edges, k, t, moments(space.edges.of_cell(k, t)));
    return loads;
  }
};

}  // namespace

AirySpace::AirySpace(const Mesh& m, const Edges& e)
    : mesh(m), edges(e), length(mean_edge_lengths(m, e)) {}

Vector4d moments_of_gradients(const Vector2d& at_i, const Vector2d& in_middle,
                              const Vector2d& at_j) {
  Vector4d b;
  b << turned_right(-5 * at_i + 4 * in_middle + at_j) / 6,
      turned_right(-at_i - 4 * in_middle + 5 * at_j) / 6;
  return b;
}

Vector4d airy_moments(const AirySpace& space, const VectorXd& airy, int edge) {
  return AiryField{space, airy}.moments(edge);
}

void add_airy_loads(const AirySpace& space, const VectorXd& airy,
                    EdgeLoadsOfAll& loads) {
  const AiryField field{space, airy};
#pragma omp parallel for
  for (int t = 0; t < space.mesh.cell_count(); ++t)
    loads.col(t) += field.loads(t);
}

}  // namespace ffcontact
