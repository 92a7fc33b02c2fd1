// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/refined_line.hpp"

#include <map>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/line_ends.hpp"

namespace ffcontact {

namespace {

using EdgeByEnds = std::map<std::pair<int, int>, int>;

EdgeByEnds boundary_by_ends(const Edges& edges) {
  EdgeByEnds boundary;
  for (int e = 0; e < edges.count(); ++e)
    if (edges.on_boundary(e))
      boundary[{edges.vertices(0, e), edges.vertices(1, e)}] = e;
  return boundary;
}

/// Rays that cross, as those of neighbours do whose directions differ where the line is
/// hollow, have no common refinement.
[[noreturn]] void refuse_shared(const Mesh& mesh, int vertex) {
  refuse("two contact edges face the same part of the opposite body near ",
         in_words(mesh.place(vertex)),
         ", because the contact direction jumps between them: state the other "
         "body first, take coarse circles for curves with corner=, or give one "
         "direction for both with normal=[nx, ny]");
}

/// The refined line while it grows.
class Refining {
 public:
  Refining(const Mesh& mesh, const Edges& edges, const ContactLine& old,
           const EdgeCuts& cuts)
      : mesh_(mesh),
        old_(old),
        cuts_(cuts),
        boundary_(boundary_by_ends(edges)),
        vertex_(old.vertex.begin(), old.vertex.end()),
        abscissa_(old.abscissa.begin(), old.abscissa.end()) {
    for (int i = 0; i < old.node_count(); ++i) weights_.emplace_back(i, i, 1.0);
  }

  /// A contact edge that faces nothing.
  void add_whole(int e, int first_vertex, int second_vertex) {
    const int edge = boundary_.find({first_vertex, second_vertex})->second;
    add_edge(e, old_.edge_node.col(e), edge, -1, 1);
  }

  /// The first node of the pieces of a contact edge.
  int first_node(const FacingPiece& piece) {
    const int e = piece.contact_edge, vertex = own_vertex(piece, piece.begin),
              node = ends_at_its_node(old_, 0, e) ? old_.edge_node(0, e)
                                                  : add_node(vertex, e, 0);
    vertex_[node] = vertex;
    return node;
  }

  /// @return the node that the piece ends at
  int add_piece(int node, const FacingPiece& piece) {
    const int e = piece.contact_edge, first = own_vertex(piece, piece.begin),
              second = own_vertex(piece, piece.end);
    const double end = old_.share(e, piece.end),
                 share = end - old_.share(e, piece.begin);
    const bool at_node = end == 1 && ends_at_its_node(old_, 1, e);
    int next = at_node ? old_.edge_node(1, e) : add_node(second, e, end);
    vertex_[next] = second;
    const int faced_first = faced_vertex(piece, piece.opposite_begin),
              faced_second = faced_vertex(piece, piece.opposite_end);
    node = node_facing(node, faced_first);
    next = node_facing(next, faced_second);
    add_edge(e, {node, next}, boundary_.find({first, second})->second,
             facing_edge(faced_first, faced_second), share);
    return next;
  }

  RefinedLine refined() const {
    RefinedLine result;
    result.parent = packed(parent_);
    result.node_weights =
        packed<WeightsByNode>(count_of(vertex_), old_.node_count(), weights_);
    put_nodes(result);
    put_edges(result.line);
    return result;
  }

 private:
  int own_vertex(const FacingPiece& piece, double place) const {
    return cuts_.vertex_at(old_.edge[piece.contact_edge], place);
  }

  int add_node(int vertex, int e, double share) {
    const int node = count_of(vertex_);
    vertex_.push_back(vertex);
    const bool from_second = !ends_at_its_node(old_, 0, e);
    abscissa_.push_back(old_.abscissa[old_.edge_node(0, e)] +
                        (from_second ? share - 1 : share) * old_.length[e]);
    weights_.emplace_back(node, old_.edge_node(0, e), 1 - share);
    weights_.emplace_back(node, old_.edge_node(1, e), share);
    return node;
  }

  int faced_vertex(const FacingPiece& piece, double place) const {
    return cuts_.vertex_at(piece.opposite_edge, place);
  }

  /// The node, or where that faces another vertex already its twin: in front of a joint
  /// between two bodies, or of a step of one, a vertex is a node against each side.
  int node_facing(int node, int vertex) {
    if (facing_.emplace(node, vertex).first->second == vertex) return node;
    const auto [twin, is_new] =
        twin_.emplace(std::pair(node, vertex), count_of(vertex_));
    if (is_new) add_twin(node);
    facing_.emplace(twin->second, vertex);
    return twin->second;
  }

  void add_twin(int node) {
    const int twin = count_of(vertex_);
    vertex_.push_back(vertex_[node]);
    abscissa_.push_back(abscissa_[node]);
    for (std::size_t k = 0, count = weights_.size(); k < count; ++k)
      if (const auto entry = weights_[k]; entry.row() == node)
        weights_.emplace_back(twin, entry.col(), entry.value());
  }

  /// The edge between two vertices of the opposite body, which runs the other way.
  int facing_edge(int first, int second) const {
    const auto facing = boundary_.find({second, first});
    if (facing == boundary_.end()) refuse_shared(mesh_, first);
    return facing->second;
  }

  void add_edge(int parent, const Vector2i& nodes, int edge, int opposite_edge,
                double share) {
    parent_.push_back(parent);
    edge_node_.push_back(nodes);
    edge_.push_back(edge);
    opposite_edge_.push_back(opposite_edge);
    share_.push_back(share);
  }

  /// That of the old nodes, or where these differ the unit vector of what is linear between.
  Vector2d direction_between(const WeightsByNode& weights, int node) const {
    WeightsByNode::InnerIterator part(weights, node);
    const Vector2d first = old_.normal.col(part.col());
    Vector2d turn = Vector2d::Zero();
    for (; part; ++part)
      turn += part.value() * (old_.normal.col(part.col()) - first);
    return turn.isZero(0) ? first : (first + turn).normalized();
  }

  void put_nodes(RefinedLine& result) const {
    ContactLine& line = result.line;
    line.vertex = packed(vertex_);
    line.abscissa = packed(abscissa_);
    line.precision = old_.precision;
    line.normal.resize(2, line.node_count());
    line.normal.leftCols(old_.node_count()) = old_.normal;
    for (int node = old_.node_count(); node < line.node_count(); ++node)
      line.normal.col(node) = direction_between(result.node_weights, node);
    Triplets facing;
    for (const auto& [node, vertex] : facing_)
      facing.emplace_back(node, vertex, 1.0);
    line.opposite =
        packed<WeightsByNode>(line.node_count(), mesh_.vertex_count(), facing);
  }

  void put_edges(ContactLine& line) const {
    line.edge = packed(edge_);
    line.opposite_edge = packed(opposite_edge_);
    line.edge_node = packed(edge_node_);
    line.length = packed(share_).cwiseProduct(old_.length(parent_));
    for (int e = 0; e < line.edge_count(); ++e)
      if (opposite_edge_[e] >= 0)
        line.pieces.push_back({e, 0, 1, opposite_edge_[e], 1, 0});
  }

  const Mesh& mesh_;
  const ContactLine& old_;
  const EdgeCuts& cuts_;
  const EdgeByEnds boundary_;
  std::vector<int> vertex_, edge_, opposite_edge_, parent_;
  std::vector<Vector2i> edge_node_;
  std::vector<double> abscissa_;
  std::vector<double> share_;  ///< of the parent's length
  std::map<int, int> facing_;  ///< vertex that a node faces
  /// of nodes that face several vertices, that which faces one of the others
  std::map<std::pair<int, int>, int> twin_;
  Triplets weights_;
};

}  // namespace

RefinedLine refined_line(const Mesh& mesh, const Edges& edges,
                         const Edges& old_edges, const ContactLine& old_line,
                         const std::vector<FacingPiece>& pieces,
                         const EdgeCuts& cuts) {
  Refining refining(mesh, edges, old_line, cuts);
  auto piece = pieces.begin();
  for (int e = 0; e < old_line.edge_count(); ++e) {
    const auto is_faced = [&] {
      return piece != pieces.end() && piece->contact_edge == e;
    };
    const auto ends = old_edges.vertices.col(old_line.edge[e]);
    if (!is_faced()) {
      refining.add_whole(e, ends[0], ends[1]);
      continue;
    }
    int node = refining.first_node(*piece);
    for (; is_faced(); ++piece) node = refining.add_piece(node, *piece);
  }
  return refining.refined();
}

}  // namespace ffcontact
