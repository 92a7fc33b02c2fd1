// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/stated_places.hpp"

#include <algorithm>
#include <map>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/interface/line_ends.hpp"

namespace ffcontact {

namespace {

/// Place on its mesh edge of point k of a contact edge; the last is the end itself, not
/// a unit in the last place beside it.
double sampled_place(const ContactLine& line, int e, int k) {
  constexpr double last = samples_of_an_edge - 1;
  if (k == last) return line.place(1, e);
  return between(line.place(0, e), line.place(1, e), k / last);
}

/// What a point of a piece faces; beyond an end of it by rounding, what the end faces.
EdgePlace faced_place(const FacingPiece& piece, double x) {
  const double share = (x - piece.begin) / (piece.end - piece.begin);
  if (share >= 1) return {piece.opposite_edge, piece.opposite_end};
  return {piece.opposite_edge, between(piece.opposite_begin, piece.opposite_end,
                                       std::max(0.0, share))};
}

using PiecesOfEdges = std::vector<std::vector<const FacingPiece*>>;

PiecesOfEdges pieces_of_edges(const ContactLine& line) {
  PiecesOfEdges pieces(line.edge_count());
  for (const FacingPiece& piece : line.pieces)
    pieces[piece.contact_edge].push_back(&piece);
  return pieces;
}

/// The first piece that does not end before x, or the last one.
const FacingPiece& piece_at(const std::vector<const FacingPiece*>& pieces,
                            double x) {
  for (const FacingPiece* piece : pieces)
    if (x <= piece->end) return *piece;
  return *pieces.back();
}

}  // namespace

StatedPlaces stated_places(const ContactLine& line, bool on_opposite) {
  StatedPlaces places(line.edge_count());
  const PiecesOfEdges pieces =
      on_opposite ? pieces_of_edges(line) : PiecesOfEdges();
  for (int e = 0; e < line.edge_count(); ++e)
    for (int k = 0; k < samples_of_an_edge; ++k) {
      const double x = sampled_place(line, e, k);
      places[e].push_back(on_opposite ? faced_place(piece_at(pieces[e], x), x)
                                      : EdgePlace{line.edge[e], x});
    }
  return places;
}

StatedAbscissae stated_abscissae(const Edges& edges, const ContactLine& stated,
                                 const ContactLine& line,
                                 const StatedPlaces& places) {
  std::map<int, int> number;  // contact edge of each mesh edge
  for (int e = 0; e < stated.edge_count(); ++e) number[stated.edge[e]] = e;
  StatedAbscissae result{VectorXi(line.node_count()),
                         VectorXd(line.node_count()),
                         Matrix2Xd(2, line.edge_count())};
  for (int e = line.edge_count() - 1; e >= 0; --e)
    for (int end = 1; end >= 0; --end) {
      const auto [edge, place] =
          end == 0 ? places[e].front() : places[e].back();
      result.edge_end(end, e) = abscissa_at(
          stated, entry_of(number, edge, "number of a stated contact edge"),
          place);
      if (!ends_at_its_node(line, end, e)) continue;
      const int node = line.edge_node(end, e);
      result.vertex[node] = edges.vertices(place < 0.5 ? 0 : 1, edge);
      result.node[node] = result.edge_end(end, e);
    }
  return result;
}

}  // namespace ffcontact
