// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/short_pieces.hpp"

namespace ffcontact {

namespace {

constexpr double least_length = 1e-4;

class LinePieces {
 public:
  LinePieces(const Mesh& mesh, const Edges& edges, const ContactLine& line)
      : mesh_(mesh), edges_(edges), line_(line), pieces_(line.pieces) {}

  std::vector<FacingPiece> without_short_ones() && {
    for (std::size_t k = 0; k < pieces_.size();)
      if (!absorbed(k)) ++k;
    for (std::size_t k = 0; k < pieces_.size(); ++k) reach_ends(k);
    return std::move(pieces_);
  }

 private:
  double length(int edge) const {
    return edge_vector(mesh_, edges_, edge).norm();
  }
  double own_length(const FacingPiece& piece) const {
    return length(line_.edge[piece.contact_edge]);
  }
  double smallest_length(const FacingPiece& piece) const {
    return least_length *
           std::min(own_length(piece), length(piece.opposite_edge));
  }

  /// Do two pieces that follow each other face parts of the same edge?
  bool face_one_edge(std::size_t k, std::size_t next) const {
    return k < pieces_.size() && next < pieces_.size() &&
           pieces_[k].opposite_edge == pieces_[next].opposite_edge;
  }

  /// A piece that all but ends with its opposite edge does.
  void reach_ends(std::size_t k) {
    FacingPiece& piece = pieces_[k];
    const double tolerance =
        smallest_length(piece) / length(piece.opposite_edge);
    if (piece.opposite_begin > 1 - tolerance && !face_one_edge(k - 1, k))
      piece.opposite_begin = 1;
    if (piece.opposite_end < tolerance && !face_one_edge(k, k + 1))
      piece.opposite_end = 0;
  }

  bool is_short(const FacingPiece& piece) const {
    const double length = (piece.end - piece.begin) * own_length(piece);
    return length < smallest_length(piece);
  }

  /// Gives a short piece to its neighbours on the contact edge and on the opposite one.
  bool absorbed(std::size_t k) {
    const FacingPiece piece = pieces_[k];
    FacingPiece *before = k > 0 ? &pieces_[k - 1] : nullptr,
                *after = k + 1 < pieces_.size() ? &pieces_[k + 1] : nullptr;
    if (!is_short(piece) || !give_own_part(piece, before, after)) return false;
    give_opposite_part(piece, before, after);
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }

  /// @return whether a neighbour is on the same contact edge
  static bool give_own_part(const FacingPiece& piece, FacingPiece* before,
                            FacingPiece* after) {
    const auto on_its_edge = [&](const FacingPiece* other) {
      return other && other->contact_edge == piece.contact_edge;
    };
    if (on_its_edge(after))
      after->begin = piece.begin;
    else if (on_its_edge(before))
      before->end = piece.end;
    else
      return false;
    return true;
  }

  static void give_opposite_part(const FacingPiece& piece, FacingPiece* before,
                                 FacingPiece* after) {
    if (before && before->opposite_edge == piece.opposite_edge)
      before->opposite_end = piece.opposite_end;
    else if (after && after->opposite_edge == piece.opposite_edge)
      after->opposite_begin = piece.opposite_begin;
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  std::vector<FacingPiece> pieces_;
};

}  // namespace

std::vector<FacingPiece> without_short_pieces(const Mesh& mesh,
                                              const Edges& edges,
                                              const ContactLine& line) {
  return LinePieces(mesh, edges, line).without_short_ones();
}

}  // namespace ffcontact
