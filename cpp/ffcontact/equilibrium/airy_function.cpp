// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_function.hpp"

#include <algorithm>

namespace ffcontact {

AirySpace::AirySpace(const Mesh& m, const Edges& e) : mesh(m), edges(e) {
  length = VectorXd::Zero(mesh.vertex_count());
  VectorXi count = VectorXi::Zero(mesh.vertex_count());
  for (int edge = 0; edge < edges.count(); ++edge) {
    const double l = edge_vector(mesh, edges, edge).norm();
    for (int end = 0; end < 2; ++end) {
      length[edges.vertices(end, edge)] += l;
      ++count[edges.vertices(end, edge)];
    }
  }
  for (int v = 0; v < mesh.vertex_count(); ++v)
    length[v] /= std::max(count[v], 1);
}

Vector4d airy_moments(const AirySpace& space, const VectorXd& airy, int edge) {
  const int i = space.edges.vertices(0, edge),
            j = space.edges.vertices(1, edge);
  const auto at_i = airy.segment<3>(space.of_vertex(i)),
             at_j = airy.segment<3>(space.of_vertex(j));
  const Vector2d side = edge_vector(space.mesh, space.edges, edge),
                 gradient_i = at_i.tail<2>(), gradient_j = at_j.tail<2>();
  const double l = side.norm();
  const Vector2d s = side / l, n(s.y(), -s.x());
  const double along =
      1.5 * (space.length[j] * at_j[0] - space.length[i] * at_i[0]) / l -
      0.25 * s.dot(gradient_i + gradient_j);
  const Vector2d gradient_m = along * s + airy[space.of_edge(edge)] * n;
  const Vector2d first = (-5 * gradient_i + 4 * gradient_m + gradient_j) / 6,
                 second = (-gradient_i - 4 * gradient_m + 5 * gradient_j) / 6;
  return {first.y(), -first.x(), second.y(), -second.x()};
}

void add_airy_loads(const AirySpace& space, const VectorXd& airy,
                    EdgeLoadsOfAll& loads) {
  const Edges& edges = space.edges;
#pragma omp parallel for
  for (int t = 0; t < space.mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector4d b = airy_moments(space, airy, edges.of_cell(k, t));
      if (edges.eta(k, t) > 0)
        loads.block<4, 1>(4 * k, t) += b;
      else
        loads.block<4, 1>(4 * k, t) -= Vector4d(b[2], b[3], b[0], b[1]);
    }
}

}  // namespace ffcontact
