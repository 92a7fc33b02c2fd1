// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/compliance_ratio.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

/// Components of n below this do not move a node along n.
constexpr double along_the_line = 1e-3;
/// Ratios beyond this, as that to a rigid trace, count as this.
constexpr double largest_ratio = 1e12;

/// 1 / (n' K_vv n) on the free components, or 0 at a vertex that none moves along n.
double nodal_compliance(const ElasticSystem& system, int vertex,
                        const Vector2d& n) {
  double stiffness = 0;
  for (int i = 0; i < 2; ++i) {
    if (system.prescribed[2 * vertex + i] || std::abs(n[i]) < along_the_line)
      continue;
    for (int j = 0; j < 2; ++j)
      if (!system.prescribed[2 * vertex + j])
        stiffness += n[i] *
                     system.stiffness.coeff(2 * vertex + i, 2 * vertex + j) *
                     n[j];
  }
  return stiffness > 0 ? 1 / stiffness : 0;
}

/// The mean of its vertices' nodal compliances along n, times its length.
double edge_compliance(const Mesh& mesh, const Edges& edges,
                       const ElasticSystem& system, int edge,
                       const Vector2d& n) {
  const auto of_vertex = [&](int k) {
    return nodal_compliance(system, edges.vertices(k, edge), n);
  };
  const double length = edge_vector(mesh, edges, edge).norm();
  return length * 0.5 * (of_vertex(0) + of_vertex(1));
}

}  // namespace

double compliance_ratio(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const ElasticSystem& system) {
  double sum = 0, weight = 0;
  for (const FacingPiece& piece : line.pieces) {
    const int own = line.edge[piece.contact_edge];
    const Vector2d n = line.edge_normal(piece.contact_edge);
    const double own_compliance = edge_compliance(mesh, edges, system, own, n);
    const double opposite_compliance =
        edge_compliance(mesh, edges, system, piece.opposite_edge, n);
    if (own_compliance == 0 && opposite_compliance == 0) continue;
    const double length =
        (piece.end - piece.begin) * edge_vector(mesh, edges, own).norm();
    const double ratio = std::clamp(opposite_compliance / own_compliance,
                                    1 / largest_ratio, largest_ratio);
    sum += length * std::log(ratio);
    weight += length;
  }
  return weight > 0 ? std::exp(sum / weight) : 1;
}

}  // namespace ffcontact
