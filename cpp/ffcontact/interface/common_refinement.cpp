// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/common_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/interface/facing_traces.hpp"

namespace ffcontact {

namespace {

/// Places on an edge that differ by less are the same.
constexpr double same_place = 1e-10;

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Pieces shorter than this part of both edges come of vertices that were meant to meet;
/// as triangles they would be too thin to compute with.
constexpr double sliver = 1e-4;

/// The pieces without slivers: their neighbours on either edge take their place, if there
/// are any, and what is left free of an opposite edge is no sliver either.
class WithoutSlivers {
 public:
  WithoutSlivers(const Mesh& mesh, const Edges& edges, const ContactLine& line)
      : mesh_(mesh), edges_(edges), line_(line), pieces_(line.pieces) {}

  std::vector<FacingPiece> pieces() {
    for (std::size_t k = 0; k < pieces_.size();)
      if (!absorbed(k)) ++k;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      FacingPiece& piece = pieces_[k];
      const double tolerance = smallest_length(piece) / opposite_length(piece);
      if (piece.opposite_begin > 1 - tolerance && !face_one_edge(k - 1, k))
        piece.opposite_begin = 1;
      if (piece.opposite_end < tolerance && !face_one_edge(k, k + 1))
        piece.opposite_end = 0;
    }
    return pieces_;
  }

 private:
  double opposite_length(const FacingPiece& piece) const {
    return edge_vector(mesh_, edges_, piece.opposite_edge).norm();
  }
  double own_length(const FacingPiece& piece) const {
    return edge_vector(mesh_, edges_, line_.edge[piece.contact_edge]).norm();
  }
  double smallest_length(const FacingPiece& piece) const {
    return sliver * std::min(own_length(piece), opposite_length(piece));
  }

  /// Do two pieces that follow each other face parts of the same edge?
  bool face_one_edge(std::size_t k, std::size_t next) const {
    return k < pieces_.size() && next < pieces_.size() &&
           pieces_[k].opposite_edge == pieces_[next].opposite_edge;
  }

  /// Gives a sliver to its neighbours.
  bool absorbed(std::size_t k) {
    const FacingPiece piece = pieces_[k];
    if ((piece.end - piece.begin) * own_length(piece) >= smallest_length(piece))
      return false;
    FacingPiece *before = k > 0 ? &pieces_[k - 1] : nullptr,
                *after = k + 1 < pieces_.size() ? &pieces_[k + 1] : nullptr;
    if (after && after->contact_edge == piece.contact_edge)
      after->begin = piece.begin;
    else if (before && before->contact_edge == piece.contact_edge)
      before->end = piece.end;
    else
      return false;
    if (before && before->opposite_edge == piece.opposite_edge)
      before->opposite_end = piece.opposite_end;
    else if (after && after->opposite_edge == piece.opposite_edge)
      after->opposite_begin = piece.opposite_begin;
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }

  const Mesh& mesh_;
  const Edges& edges_;
  const ContactLine& line_;
  std::vector<FacingPiece> pieces_;
};

bool same(const std::vector<FacingPiece>& a,
          const std::vector<FacingPiece>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const FacingPiece& p, const FacingPiece& q) {
                      return p.begin == q.begin && p.end == q.end &&
                             p.opposite_begin == q.opposite_begin &&
                             p.opposite_end == q.opposite_end;
                    });
}

/// The vertices along one old edge, from its first to its second, by their places.
using CutEdge = std::map<double, int>;

class Refiner {
 public:
  Refiner(const Mesh& mesh, const Edges& edges, const ContactLine& line)
      : old_(mesh),
        old_edges_(edges),
        old_line_(line),
        pieces_(WithoutSlivers(mesh, edges, line).pieces()) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      vertices_.push_back(mesh.vertices.col(v));
      vertex_weights_.emplace_back(v, v, 1.0);
    }
    for (const FacingPiece& piece : pieces_) {
      for (double place : {piece.begin, piece.end})
        cut(line.edge[piece.contact_edge], place);
      for (double place : {piece.opposite_begin, piece.opposite_end})
        cut(piece.opposite_edge, place);
    }
  }

  CommonRefinement refinement() {
    number_new_vertices();
    cut_triangles();
    CommonRefinement result;
    put_mesh(result);
    result.edges = edges_of(result.mesh);
    put_parent_edges(result);
    put_line(result);
    result.exact = same(pieces_, old_line_.pieces);
    return result;
  }

 private:
  void cut(int edge, double place) {
    CutEdge& places = cuts_[edge];
    if (places.empty())
      places = {{0.0, old_edges_.vertices(0, edge)},
                {1.0, old_edges_.vertices(1, edge)}};
    if (find(places, place) == places.end()) places.emplace(place, -1);
  }

  static CutEdge::const_iterator find(const CutEdge& places, double place) {
    const auto found = places.lower_bound(place - same_place);
    return found != places.end() && found->first < place + same_place
               ? found
               : places.end();
  }

  int vertex_at(int edge, double place) const {
    return find(cuts_.at(edge), place)->second;
  }

  void number_new_vertices() {
    for (auto& [edge, places] : cuts_)
      for (auto& [place, vertex] : places) {
        if (vertex >= 0) continue;
        vertex = static_cast<int>(vertices_.size());
        const int first = old_edges_.vertices(0, edge),
                  second = old_edges_.vertices(1, edge);
        vertices_.push_back((1 - place) * old_.vertices.col(first) +
                            place * old_.vertices.col(second));
        vertex_weights_.emplace_back(vertex, first, 1 - place);
        vertex_weights_.emplace_back(vertex, second, place);
      }
  }

  void cut_triangles() {
    for (int t = 0; t < old_.cell_count(); ++t) {
      triangles_.push_back(old_.cells.col(t));
      parent_.push_back(t);
    }
    for (const auto& [edge, places] : cuts_)
      if (places.size() > 2) cut_triangle(old_edges_.cells(0, edge), places);
  }

  /// Replaces the part of an old triangle that lies on an edge by a fan. The edge has its
  /// triangle on the left.
  void cut_triangle(int old_triangle, const CutEdge& places) {
    const int first = places.begin()->second, second = places.rbegin()->second;
    std::vector<int>& parts =
        parts_.try_emplace(old_triangle, 1, old_triangle).first->second;
    for (int part : parts)
      for (int k = 0; k < 3; ++k) {
        const Vector3i triangle = triangles_[part];
        if (triangle[k] != first || triangle[(k + 1) % 3] != second) continue;
        const int apex = triangle[(k + 2) % 3];
        for (auto a = places.begin(), b = std::next(a); b != places.end();
             ++a, ++b) {
          const Vector3i piece(a->second, b->second, apex);
          if (a == places.begin()) {
            triangles_[part] = piece;
            continue;
          }
          parts.push_back(static_cast<int>(triangles_.size()));
          triangles_.push_back(piece);
          parent_.push_back(old_triangle);
        }
        return;
      }
  }

  void put_mesh(CommonRefinement& result) const {
    Mesh& mesh = result.mesh;
    mesh.origin = old_.origin;
    mesh.vertices.resize(2, static_cast<Index>(vertices_.size()));
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      mesh.vertices.col(v) = vertices_[v];
    mesh.cells.resize(3, static_cast<Index>(triangles_.size()));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      mesh.cells.col(t) = triangles_[t];
    result.parent =
        Map<const VectorXi>(parent_.data(), static_cast<Index>(parent_.size()));
    result.vertex_weights.resize(mesh.vertices.cols(), old_.vertices.cols());
    result.vertex_weights.setFromTriplets(vertex_weights_.begin(),
                                          vertex_weights_.end());

    std::vector<int> edge_of_column(old_.boundary.cols(), -1);
    for (const auto& [edge, places] : cuts_)
      edge_of_column[old_edges_.boundary_index[edge]] = edge;
    std::vector<Vector2i> boundary;
    std::vector<int> parent;
    for (int b = 0; b < old_.boundary.cols(); ++b) {
      const int edge = edge_of_column[b];
      if (edge < 0) {
        boundary.push_back(old_.boundary.col(b));
        parent.push_back(b);
        continue;
      }
      const CutEdge& places = cuts_.at(edge);
      for (auto first = places.begin(), second = std::next(first);
           second != places.end(); ++first, ++second) {
        boundary.emplace_back(first->second, second->second);
        parent.push_back(b);
      }
    }
    const auto columns = static_cast<Index>(boundary.size());
    mesh.boundary.resize(2, columns);
    mesh.boundary_label.resize(columns);
    result.parent_boundary = Map<const VectorXi>(parent.data(), columns);
    for (Index b = 0; b < columns; ++b) {
      mesh.boundary.col(b) = boundary[b];
      mesh.boundary_label[b] = old_.boundary_label[parent[b]];
    }
  }

  bool lies_on(int vertex, int edge) const {
    if (vertex < old_.vertex_count())
      return old_edges_.vertices(0, edge) == vertex ||
             old_edges_.vertices(1, edge) == vertex;
    const auto places = cuts_.find(edge);
    if (places == cuts_.end()) return false;
    return std::any_of(places->second.begin(), places->second.end(),
                       [&](const auto& at) { return at.second == vertex; });
  }

  void put_parent_edges(CommonRefinement& result) const {
    result.parent_edge = VectorXi::Constant(result.edges.count(), -1);
    for (int t = 0; t < result.mesh.cell_count(); ++t) {
      const int old = result.parent[t];
      for (int k = 0; k < 3; ++k) {
        const int edge = result.edges.of_cell(k, t);
        for (int side : old_edges_.of_cell.col(old))
          if (lies_on(result.edges.vertices(0, edge), side) &&
              lies_on(result.edges.vertices(1, edge), side))
            result.parent_edge[edge] = side;
      }
    }
  }

  /// Rays that cross, as those of neighbours do whose directions differ where the line is
  /// hollow, have no common refinement.
  [[noreturn]] void refuse_shared(int vertex) const {
    const Vector2d x = old_.origin + vertices_[vertex];
    refuse("two contact edges face the same part of the opposite body near (",
           x.x(), ", ", x.y(),
           "), because the contact direction jumps between them: give one "
           "direction for "
           "both with normal=[nx, ny]");
  }

  void put_line(CommonRefinement& result) const {
    std::map<std::pair<int, int>, int> boundary_edge;
    for (int e = 0; e < result.edges.count(); ++e)
      if (result.edges.on_boundary(e))
        boundary_edge.emplace(
            std::pair(result.edges.vertices(0, e), result.edges.vertices(1, e)),
            e);

    LineParts parts(old_line_);
    auto piece = pieces_.begin();
    for (int e = 0; e < old_line_.edge_count(); ++e) {
      const int edge = old_line_.edge[e];
      if (piece == pieces_.end() || piece->contact_edge != e) {
        const std::pair ends(old_edges_.vertices(0, edge),
                             old_edges_.vertices(1, edge));
        parts.add_edge(e, old_line_.edge_node(0, e), old_line_.edge_node(1, e),
                       boundary_edge.find(ends)->second, -1, 1);
        continue;
      }
      int node =
          ends_at_its_node(old_line_, 0, e)
              ? old_line_.edge_node(0, e)
              : parts.add_node(vertex_at(edge, piece->begin), e, 0, old_line_);
      parts.vertex[node] = vertex_at(edge, piece->begin);
      for (; piece != pieces_.end() && piece->contact_edge == e; ++piece) {
        const int first = vertex_at(edge, piece->begin),
                  second = vertex_at(edge, piece->end);
        const int facing_first =
            vertex_at(piece->opposite_edge, piece->opposite_begin);
        const int facing_second =
            vertex_at(piece->opposite_edge, piece->opposite_end);
        const double begin = old_line_.share(e, piece->begin),
                     end = old_line_.share(e, piece->end);
        const bool at_node = end == 1 && ends_at_its_node(old_line_, 1, e);
        const int next = at_node ? old_line_.edge_node(1, e)
                                 : parts.add_node(second, e, end, old_line_);
        parts.vertex[next] = second;
        parts.face(node, facing_first);
        parts.face(next, facing_second);
        const auto facing = boundary_edge.find({facing_second, facing_first});
        if (facing == boundary_edge.end()) refuse_shared(facing_first);
        parts.add_edge(e, node, next,
                       boundary_edge.find({first, second})->second,
                       facing->second, end - begin);
        node = next;
      }
    }
    parts.put(result, old_line_);
  }

  /// The refined line while it grows.
  struct LineParts {
    std::vector<int> vertex, edge, opposite_edge, parent_edge;
    std::vector<Vector2i> edge_node;
    std::vector<double> abscissa;
    std::vector<double> share;  ///< of the parent's length
    std::map<int, int> facing;  ///< vertex that a node faces
    Triplets weights;           ///< node_weights

    explicit LineParts(const ContactLine& line)
        : vertex(line.vertex.begin(), line.vertex.end()),
          abscissa(line.abscissa.begin(), line.abscissa.end()) {
      for (int i = 0; i < line.node_count(); ++i)
        weights.emplace_back(i, i, 1.0);
    }
    int add_node(int at, int e, double share, const ContactLine& line) {
      const int node = static_cast<int>(vertex.size());
      vertex.push_back(at);
      const bool from_second = !ends_at_its_node(line, 0, e);
      abscissa.push_back(line.abscissa[line.edge_node(0, e)] +
                         (from_second ? share - 1 : share) * line.length[e]);
      weights.emplace_back(node, line.edge_node(0, e), 1 - share);
      weights.emplace_back(node, line.edge_node(1, e), share);
      return node;
    }
    void face(int node, int opposite_vertex) {
      facing.emplace(node, opposite_vertex);
    }
    void add_edge(int parent, int first, int second, int mesh_edge,
                  int opposite, double part) {
      parent_edge.push_back(parent);
      edge_node.emplace_back(first, second);
      edge.push_back(mesh_edge);
      opposite_edge.push_back(opposite);
      share.push_back(part);
    }
    void put(CommonRefinement& result, const ContactLine& old) const {
      const auto p = static_cast<Index>(vertex.size()),
                 m = static_cast<Index>(edge.size());
      result.node_weights.resize(p, old.node_count());
      result.node_weights.setFromTriplets(weights.begin(), weights.end());
      ContactLine& line = result.line;
      line.vertex = Map<const VectorXi>(vertex.data(), p);
      line.normal.resize(2, p);
      line.normal.leftCols(old.node_count()) = old.normal;
      for (Index node = old.node_count(); node < p; ++node)
        line.normal.col(node) = old.normal.col(
            WeightsByNode::InnerIterator(result.node_weights, node).col());
      line.abscissa = Map<const VectorXd>(abscissa.data(), p);
      line.precision = old.precision;
      line.edge = Map<const VectorXi>(edge.data(), m);
      line.opposite_edge = Map<const VectorXi>(opposite_edge.data(), m);
      result.parent_contact_edge = Map<const VectorXi>(parent_edge.data(), m);
      line.edge_node.resize(2, m);
      line.length.resize(m);
      for (Index e = 0; e < m; ++e) {
        line.edge_node.col(e) = edge_node[e];
        line.length[e] = share[e] * old.length[parent_edge[e]];
        if (opposite_edge[e] >= 0)
          line.pieces.push_back(
              {static_cast<int>(e), 0, 1, opposite_edge[e], 1, 0});
      }
      Triplets selection;
      for (const auto& [node, opposite_vertex] : facing)
        selection.emplace_back(node, opposite_vertex, 1.0);
      line.opposite.resize(p, result.mesh.vertices.cols());
      line.opposite.setFromTriplets(selection.begin(), selection.end());
    }
  };

  const Mesh& old_;
  const Edges& old_edges_;
  const ContactLine& old_line_;
  const std::vector<FacingPiece> pieces_;
  std::map<int, CutEdge> cuts_;  ///< by old edge
  std::vector<Vector2d> vertices_;
  std::vector<Vector3i> triangles_;
  std::vector<int> parent_;
  /// triangles that an old triangle was cut into
  std::map<int, std::vector<int>> parts_;
  Triplets vertex_weights_;
};

}  // namespace

CommonRefinement common_refinement(const Mesh& mesh, const Edges& edges,
                                   const ContactLine& line) {
  return Refiner(mesh, edges, line).refinement();
}

}  // namespace ffcontact
