// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/compliance_ratio.hpp"

#include "ffcontact/contact/checks/facet_compliance.hpp"

namespace ffcontact {

double compliance_ratio(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const ElasticSystem& system) {
  MeanRatio mean;
  for (const FacingPiece& piece : line.pieces) {
    const int own = line.edge[piece.contact_edge];
    const Vector2d n = line.edge_normal(piece.contact_edge);
    const auto compliance = [&](int edge) {
      const double length = edge_vector(mesh, edges, edge).norm();
      return facet_compliance<2>(edges, system, edge, length, n);
    };
    mean.add(compliance(own), compliance(piece.opposite_edge),
             (piece.end - piece.begin) * edge_vector(mesh, edges, own).norm());
  }
  return mean.value();
}

}  // namespace ffcontact
