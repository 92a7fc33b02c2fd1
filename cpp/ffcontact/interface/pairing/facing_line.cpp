// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_line.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/interface/pairing/directed_pieces.hpp"
#include "ffcontact/interface/pairing/joined_pieces.hpp"
#include "ffcontact/interface/pairing/opposite_projection.hpp"

namespace ffcontact {

namespace {

/// Places on an edge that differ by less are the same.
constexpr double same_spot = 1e-10;

using Pieces = std::vector<DirectedPiece>;

/// A piece seen from the opposite body, with n turned round.
/// @param opposite_edge  its number on the line of that body
DirectedPiece turned(const ContactLine& line, const DirectedPiece& directed,
                     int opposite_edge) {
  const FacingPiece& p = directed.piece;
  return {{opposite_edge, p.opposite_end, p.opposite_begin,
           line.edge[p.contact_edge], p.end, p.begin, p.gap_end, p.gap_begin},
          -directed.n_end,
          -directed.n_begin};
}

bool comes_before(const DirectedPiece& a, const DirectedPiece& b) {
  return std::pair(a.piece.contact_edge, a.piece.begin) <
         std::pair(b.piece.contact_edge, b.piece.begin);
}

/// The pieces of a line seen from the opposite one, ascending.
Pieces turned(const ContactLine& line, const ContactLine& opposite) {
  std::map<int, int> number;  // of each mesh edge on the opposite line
  for (int e = 0; e < opposite.edge_count(); ++e) number[opposite.edge[e]] = e;
  Pieces result;
  for (const DirectedPiece& own : directed(line, line.pieces))
    result.push_back(turned(line, own,
                            entry_of(number, own.piece.opposite_edge,
                                     "number of an opposite edge")));
  std::sort(result.begin(), result.end(), comes_before);
  return result;
}

/// Pieces that all but begin where the one before ends do so. Nothing where two of them
/// overlap.
std::optional<Pieces> without_overlap(Pieces pieces) {
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const FacingPiece& before = pieces[k - 1].piece;
    FacingPiece& piece = pieces[k].piece;
    if (piece.contact_edge != before.contact_edge) continue;
    if (piece.begin < before.end - same_spot) return std::nullopt;
    if (piece.begin < before.end + same_spot) piece.begin = before.end;
  }
  return pieces;
}

}  // namespace

ContactLine facing_line(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const FacingTraces& traces) {
  const Pieces pieces = directed(line, traces.pieces);
  return with_opposite(mesh, edges, joined_pieces(edges, line, pieces));
}

std::optional<ContactLine> exchanged_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels) {
  ContactLine whole = smooth_contact_line(mesh, edges, opposite_labels);
  whole.precision = std::max(whole.precision, line.precision);
  const auto pieces = without_overlap(turned(line, whole));
  if (!pieces) return std::nullopt;
  const Pieces kept = without_slivers(*pieces);
  return with_opposite(mesh, edges, joined_pieces(edges, whole, kept));
}

}  // namespace ffcontact
