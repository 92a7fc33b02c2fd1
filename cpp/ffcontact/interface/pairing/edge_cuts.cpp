// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/edge_cuts.hpp"

#include "ffcontact/base/entry_of.hpp"

namespace ffcontact {

namespace {

/// Places on an edge that differ by less are the same.
constexpr double same_place = 1e-10;

CutEdge::const_iterator find(const CutEdge& places, double place) {
  const auto found = places.lower_bound(place - same_place);
  const bool is_there =
      found != places.end() && found->first < place + same_place;
  return is_there ? found : places.end();
}

void cut(const Edges& edges, int edge, double place, EdgeCuts& cuts) {
  constexpr int unnumbered = -1;
  CutEdge& places = cuts.of_edge[edge];
  if (places.empty())
    places = {{0.0, edges.vertices(0, edge)}, {1.0, edges.vertices(1, edge)}};
  if (find(places, place) == places.end()) places.emplace(place, unnumbered);
}

void number_new_vertices(int next, EdgeCuts& cuts) {
  for (auto& [edge, places] : cuts.of_edge)
    for (auto& [place, vertex] : places)
      if (vertex < 0) vertex = next++;
}

}  // namespace

int EdgeCuts::vertex_at(int edge, double place) const {
  return find(entry_of(of_edge, edge, "cut of an edge"), place)->second;
}

bool EdgeCuts::lies_on(int vertex, int edge) const {
  const auto found = of_edge.find(edge);
  if (found == of_edge.end()) return false;
  for (const auto& [place, there] : found->second)
    if (there == vertex) return true;
  return false;
}

EdgeCuts edge_cuts(const Mesh& mesh, const Edges& edges,
                   const ContactLine& line,
                   const std::vector<FacingPiece>& pieces) {
  EdgeCuts cuts;
  for (const FacingPiece& piece : pieces) {
    for (double place : {piece.begin, piece.end})
      cut(edges, line.edge[piece.contact_edge], place, cuts);
    for (double place : {piece.opposite_begin, piece.opposite_end})
      cut(edges, piece.opposite_edge, place, cuts);
  }
  number_new_vertices(mesh.vertex_count(), cuts);
  return cuts;
}

}  // namespace ffcontact
