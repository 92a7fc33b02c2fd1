// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/line_oscillation.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/estimate/error/facet_oscillation.hpp"

namespace ffcontact {

namespace {

/// q of a contact edge [MPa].
Vector2d beyond_linear(const ContactLine& line,
                       const ContactDensities& densities, int e) {
  const Vector4d r = end_values(densities, e);
  const Vector2d change = r.head<2>() - r.tail<2>();
  return (line.frame(line.edge_node(0, e)) - line.frame(line.edge_node(1, e))) *
         change / 6;
}

}  // namespace

double line_oscillation(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const Hooke& hooke,
                        const ContactDensities& densities) {
  OscillationSum sum;
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!turns(line, e)) continue;
    const Vector2d q = beyond_linear(line, densities, e) * line.length[e];
    for (const int edge : {line.edge[e], facing_edge(line, e)}) {
      if (edge < 0) continue;
      const int cell = edges.cells(0, edge);
      const double length = facet_measure(mesh, edges, edge);
      // the same force on another length
      const Matrix2d square = q * q.transpose() / (5 * length);
      sum.add(cell, facet_oscillation_square<2>(corners_of(mesh, cell),
                                                hooke[cell].inverse(), length,
                                                square));
    }
  }
  return sum.norm();
}

}  // namespace ffcontact
