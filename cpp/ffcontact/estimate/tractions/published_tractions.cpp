// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/published_tractions.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

/// Sine of the angle below which a contact tangent is that of its edge.
constexpr double parallel = 1e-13;

/// From the first to the second node of an edge.
Vector2d own_side(const Mesh& mesh, const ContactLine& line, int e) {
  return mesh.vertices.col(line.vertex[line.edge_node(1, e)]) -
         mesh.vertices.col(line.vertex[line.edge_node(0, e)]);
}

/// The same on the opposite body; 0 where the foundation is rigid.
Vector2d opposite_side(const Mesh& mesh, const ContactLine& line, int e) {
  Vector2d side = Vector2d::Zero();
  for (int end = 0; end < 2; ++end)
    visit_opposite(
        line, line.edge_node(end, e), [&](int vertex, double weight) {
          side += (end == 0 ? -weight : weight) * mesh.vertices.col(vertex);
        });
  return side;
}

/// Whether the contact tangent is not that of the edge or of the edge that it faces, as
/// on a line of given directions.
bool is_skew(const Mesh& mesh, const ContactLine& line, int e) {
  const Vector2d normal = line.edge_normal(e);
  const double most = parallel * line.length[e];
  return std::abs(normal.dot(own_side(mesh, line, e))) > most ||
         std::abs(normal.dot(opposite_side(mesh, line, e))) > most;
}

}  // namespace

ConeCorrection published_tractions(const Mesh& mesh, const ContactLine& line,
                                   const ContactLaw<2>& law,
                                   const ContactDensities& computed) {
  ConeCorrection correction = correct_to_cone(line, law, computed);
  for (int e = 0; e < line.edge_count(); ++e) {
    if (correction.shift[e] == 0 || !is_skew(mesh, line, e)) continue;
    set_end_values(correction.densities, e, end_values(computed, e));
    correction.shift[e] = 0;
    correction.uncorrected.push_back(e);
  }
  std::sort(correction.uncorrected.begin(), correction.uncorrected.end());
  return correction;
}

}  // namespace ffcontact
