// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/joined_pieces.hpp"

#include <map>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/interface/line_ends.hpp"

namespace ffcontact {

namespace {

/// Directions that differ by less are the same.
constexpr double same_direction = 1e-9;

bool same(const Vector2d& a, const Vector2d& b) {
  return (a - b).norm() < same_direction;
}

/// Pieces of one mesh edge that follow each other, by the first and the last.
struct Run {
  DirectedPiece first, last;
  int edge() const { return first.piece.contact_edge; }
  double begin() const { return first.piece.begin; }
  double end() const { return last.piece.end; }
  double share() const { return end() - begin(); }
};

class Joining {
 public:
  Joining(const Edges& edges, const ContactLine& whole)
      : edges_(edges), whole_(whole) {}

  ContactLine line(const std::vector<DirectedPiece>& pieces) {
    for (const DirectedPiece& piece : pieces) append(piece);
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      const bool continues = k > 0 && share_a_node(runs_[k - 1], runs_[k]) &&
                             runs_[k].share() < runs_[k - 1].share();
      const bool precedes = k + 1 < runs_.size() &&
                            share_a_node(runs_[k], runs_[k + 1]) &&
                            runs_[k].share() < runs_[k + 1].share();
      add_edge(runs_[k], continues, precedes);
    }
    return joined();
  }

 private:
  bool goes_on(const DirectedPiece& next) const {
    if (runs_.empty()) return false;
    const DirectedPiece& last = runs_.back().last;
    return go_on(last, next) && same(last.n_end, next.n_begin);
  }

  void append(const DirectedPiece& next) {
    if (!goes_on(next)) runs_.push_back({next, next});
    runs_.back().last = next;
    pieces_.push_back(next.piece);
    pieces_.back().contact_edge = count_of(runs_) - 1;
  }

  bool share_a_node(const Run& run, const Run& next) const {
    return run.end() == 1 && next.begin() == 0 &&
           whole_.edge_node(1, run.edge()) ==
               whole_.edge_node(0, next.edge()) &&
           same(run.last.n_end, next.first.n_begin);
  }

  /// @param continues, precedes  whether the edge takes its density from the larger part
  ///                   of an edge before or after it
  void add_edge(const Run& run, bool continues, bool precedes) {
    const int node =
        precedes ? -1 : node_at(run.edge(), run.begin(), run.first.n_begin);
    const int next =
        continues ? node : node_at(run.edge(), run.end(), run.last.n_end);
    edge_node_.emplace_back(precedes ? next : node, next);
    part_.emplace_back(run.begin(), run.end());
    edge_.push_back(run.edge());
  }

  int node_at(int e, double place, const Vector2d& n) {
    if (place == 0 || place == 1) return node_at_end(e, place == 0 ? 0 : 1, n);
    const int nearest = place < 0.5 ? 0 : 1;
    return add_node(edges_.vertices(nearest, whole_.edge[e]), e, place, n);
  }

  /// One that is there already where contact edges meet at a node of the whole line in
  /// one direction.
  int node_at_end(int e, int end, const Vector2d& n) {
    const int at = whole_.edge_node(end, e);
    std::vector<int>& there = nodes_at_[at];
    for (int node : there)
      if (same(normal_[node], n)) return node;
    there.push_back(add_node(whole_.vertex[at], e, end, n));
    return there.back();
  }

  int add_node(int vertex, int e, double place, const Vector2d& n) {
    vertex_.push_back(vertex);
    normal_.push_back(n);
    abscissa_.push_back(abscissa_at(whole_, e, place));
    return count_of(vertex_) - 1;
  }

  ContactLine joined() const {
    ContactLine line;
    line.vertex = packed(vertex_);
    line.normal = packed(normal_);
    line.abscissa = packed(abscissa_);
    line.edge_node = packed(edge_node_);
    line.edge = whole_.edge(edge_);
    line.precision = whole_.precision;
    line.pieces = pieces_;
    put_parts(line);
    return line;
  }

  void put_parts(ContactLine& line) const {
    const Matrix2Xd part = packed(part_);
    const VectorXd share = part.row(1) - part.row(0);
    line.length = whole_.length(edge_).cwiseProduct(share);
    const bool whole =
        part.row(0).isZero(0) && (part.row(1).array() == 1).all();
    if (!whole) line.part = part;
  }

  const Edges& edges_;
  const ContactLine& whole_;
  std::vector<Run> runs_;
  std::vector<int> vertex_, edge_;  ///< edges of the whole line
  std::vector<Vector2d> normal_, part_;
  std::vector<Vector2i> edge_node_;
  std::vector<double> abscissa_;
  std::vector<FacingPiece> pieces_;
  std::map<int, std::vector<int>> nodes_at_;  ///< by node of the whole line
};

}  // namespace

ContactLine joined_pieces(const Edges& edges, const ContactLine& whole,
                          const std::vector<DirectedPiece>& pieces) {
  return Joining(edges, whole).line(pieces);
}

}  // namespace ffcontact
