// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/directed_pieces.hpp"

#include "ffcontact/base/plane.hpp"

namespace ffcontact {

namespace {

/// Ends of a trace this near to a vertex, in edge lengths, are the vertex: the rest of
/// the edge would be too thin to compute with.
constexpr double least_part = 1e-4;

/// Gives the part of the opposite edge that a piece faces to the piece before or after
/// the vertex that it all but is.
void put_end(const FacingPiece& sliver, FacingPiece& before) {
  if (before.opposite_edge != sliver.opposite_edge) return;
  before.opposite_end = sliver.opposite_end;
  before.gap_end = sliver.gap_end;
}
void put_begin(const FacingPiece& sliver, FacingPiece& after) {
  if (after.opposite_edge != sliver.opposite_edge) return;
  after.opposite_begin = sliver.opposite_begin;
  after.gap_begin = sliver.gap_begin;
}

/// The contact direction at a place of a contact edge; the same to the last digit where
/// both ends have the same.
Vector2d direction_at(const ContactLine& line, int e, double place) {
  const Vector2d first = line.normal.col(line.edge_node(0, e)),
                 second = line.normal.col(line.edge_node(1, e));
  const double share = line.share(e, place);
  if (first == second || share == 0) return first;
  return share == 1 ? second : between(first, second, share).normalized();
}

/// The piece after the last that goes on from piece k.
std::size_t end_of_run(const std::vector<DirectedPiece>& pieces,
                       std::size_t k) {
  std::size_t next = k + 1;
  while (next < pieces.size() && go_on(pieces[next - 1], pieces[next])) ++next;
  return next;
}

/// Pieces of one edge go on where the hole between them is as thin.
void close_narrow_holes(std::vector<DirectedPiece>& pieces) {
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const FacingPiece& before = pieces[k - 1].piece;
    FacingPiece& piece = pieces[k].piece;
    const double hole = piece.begin - before.end;
    if (piece.contact_edge != before.contact_edge || hole >= least_part)
      continue;
    piece.begin = before.end;
    pieces[k].n_begin = pieces[k - 1].n_end;
  }
}

}  // namespace

std::vector<DirectedPiece> directed(const ContactLine& line,
                                    const std::vector<FacingPiece>& pieces) {
  std::vector<DirectedPiece> result;
  for (const FacingPiece& piece : pieces) {
    const auto at = [&](double place) {
      return direction_at(line, piece.contact_edge, place);
    };
    result.push_back({piece, at(piece.begin), at(piece.end)});
  }
  return result;
}

bool go_on(const DirectedPiece& before, const DirectedPiece& after) {
  return before.piece.contact_edge == after.piece.contact_edge &&
         before.piece.end == after.piece.begin;
}

std::vector<DirectedPiece> without_slivers(std::vector<DirectedPiece> pieces) {
  close_narrow_holes(pieces);
  std::vector<DirectedPiece> kept;
  for (std::size_t k = 0, next = 0; k < pieces.size(); k = next) {
    next = end_of_run(pieces, k);
    FacingPiece &first = pieces[k].piece, &last = pieces[next - 1].piece;
    if (last.end <= least_part) {
      if (!kept.empty()) put_end(first, kept.back().piece);
    } else if (first.begin >= 1 - least_part) {
      if (next < pieces.size()) put_begin(last, pieces[next].piece);
    } else {
      if (first.begin <= least_part) first.begin = 0;
      if (last.end >= 1 - least_part) last.end = 1;
      kept.insert(kept.end(), &pieces[k], &pieces[next - 1] + 1);
    }
  }
  return kept;
}

}  // namespace ffcontact
