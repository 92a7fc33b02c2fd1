// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/common_refinement.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/interface/pairing/cut_mesh.hpp"
#include "ffcontact/interface/pairing/refined_line.hpp"
#include "ffcontact/interface/pairing/short_pieces.hpp"

namespace ffcontact {

namespace {

bool same_places(const FacingPiece& p, const FacingPiece& q) {
  return p.begin == q.begin && p.end == q.end &&
         p.opposite_begin == q.opposite_begin &&
         p.opposite_end == q.opposite_end;
}

bool same(const std::vector<FacingPiece>& a,
          const std::vector<FacingPiece>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_places);
}

/// Which vertices lie on which old edges.
struct OldEdges {
  const Edges& edges;
  const EdgeCuts& cuts;
  int vertex_count;

  bool have(int vertex, int edge) const {
    const auto ends = edges.vertices.col(edge);
    return vertex < vertex_count ? ends[0] == vertex || ends[1] == vertex
                                 : cuts.lies_on(vertex, edge);
  }

  /// The side of an old triangle that an edge is a part of, or -1.
  int parent(int triangle, const Edges& refined, int edge) const {
    int parent = -1;
    for (int side : edges.of_cell.col(triangle))
      if (have(refined.vertices(0, edge), side) &&
          have(refined.vertices(1, edge), side))
        parent = side;
    return parent;
  }
};

VectorXi parent_edges(const OldEdges& old, const CutMesh& cut,
                      const Edges& edges) {
  VectorXi parents = VectorXi::Constant(edges.count(), -1);
  for (int t = 0; t < cut.mesh.cell_count(); ++t)
    for (int edge : edges.of_cell.col(t)) {
      const int parent = old.parent(cut.parent[t], edges, edge);
      if (parent >= 0) parents[edge] = parent;
    }
  return parents;
}

}  // namespace

CommonRefinement common_refinement(const Mesh& mesh, const Edges& edges,
                                   const ContactLine& line) {
  const auto pieces = without_short_pieces(mesh, edges, line);
  const EdgeCuts cuts = edge_cuts(mesh, edges, line, pieces);
  CutMesh cut = cut_mesh(mesh, edges, cuts);
  Edges new_edges = edges_of(cut.mesh);
  RefinedLine refined =
      refined_line(cut.mesh, new_edges, edges, line, pieces, cuts);

  CommonRefinement result;
  result.parent_edge =
      parent_edges({edges, cuts, mesh.vertex_count()}, cut, new_edges);
  result.mesh = std::move(cut.mesh);
  result.edges = std::move(new_edges);
  result.parent = std::move(cut.parent);
  result.parent_boundary = std::move(cut.parent_boundary);
  result.vertex_weights = std::move(cut.vertex_weights);
  result.line = std::move(refined.line);
  result.parent_contact_edge = std::move(refined.parent);
  result.node_weights = std::move(refined.node_weights);
  result.exact = same(pieces, line.pieces);
  return result;
}

}  // namespace ffcontact
