// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_line.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

/// Directions that turn by less along an edge are those of a straight line.
constexpr double straight_turn = 0.01;

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

/// How directions turn along the edges.
struct LineTurning {
  double own = 0, common = 0;  ///< sums of a . a and a . b
  CurvedEdge most{-1, 0};

  void add(const CurvedEdge& edge, const Vector2d& a, const Vector2d& b) {
    own += a.squaredNorm();
    common += a.dot(b);
    if (edge.sagitta > most.sagitta) most = edge;
  }
  bool fits() const { return common > 0.5 * own && common < 2 * own; }
};

}  // namespace

std::optional<CurvedEdge> edge_of_fitted_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<FacingPiece>& pieces) {
  if (face_one_by_one(pieces)) return std::nullopt;
  const Matrix2Xd sums = opposite_normals(mesh, edges, line, pieces);
  const auto faces_nothing = [&](int i) { return sums.col(i).isZero(0); };
  LineTurning turning;
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const Vector2d a = line.normal.col(j) - line.normal.col(i);
    if (a.norm() <= straight_turn || faces_nothing(i) || faces_nothing(j))
      continue;
    turning.add({line.edge[e], line.length[e] * a.norm() / 8}, a,
                sums.col(i).normalized() - sums.col(j).normalized());
  }
  return turning.fits() ? std::optional(turning.most) : std::nullopt;
}

}  // namespace ffcontact
