// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_line.hpp"

#include <algorithm>

#include "ffcontact/interface/common_turn.hpp"

namespace ffcontact {

namespace {

/// Sums over opposite edges of m by length at each node [2 x p], zero where nothing faces
/// it.
Matrix2Xd opposite_normals(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<FacingPiece>& pieces) {
  Matrix2Xd sums = Matrix2Xd::Zero(2, line.node_count());
  for (const FacingPiece& piece : pieces)
    for (int node : line.edge_node.col(piece.contact_edge))
      sums.col(node) += (piece.end - piece.begin) *
                        line.length[piece.contact_edge] *
                        facet_normal(mesh, edges, piece.opposite_edge);
  return sums;
}

bool face_one_by_one(const std::vector<FacingPiece>& pieces) {
  return std::all_of(pieces.begin(), pieces.end(),
                     [](const FacingPiece& piece) { return piece.is_whole(); });
}

}  // namespace

std::optional<CurvedEdge> edge_of_fitted_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<FacingPiece>& pieces) {
  if (face_one_by_one(pieces)) return std::nullopt;
  const Matrix2Xd sums = opposite_normals(mesh, edges, line, pieces);
  const auto faces_nothing = [&](int i) { return sums.col(i).isZero(0); };
  CommonTurn turn;
  CurvedEdge most{-1, 0};
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    if (faces_nothing(i) || faces_nothing(j)) continue;
    const Vector2d a = line.normal.col(j) - line.normal.col(i),
                   b = sums.col(i).normalized() - sums.col(j).normalized();
    const double sagitta = line.length[e] * a.norm() / 8;
    if (turn.add(a, b) && sagitta > most.sagitta)
      most = {line.edge[e], sagitta};
  }
  return turn.fits() ? std::optional(most) : std::nullopt;
}

}  // namespace ffcontact
