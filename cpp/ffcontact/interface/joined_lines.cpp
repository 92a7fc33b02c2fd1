// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_lines.hpp"

#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// How much there is of something: of all lines, or of those put so far.
struct Extent {
  int nodes = 0, edges = 0;
  Index vertices = 0;  ///< of the bodies that they face
  bool parts = false;

  void add(const ContactLine& line) {
    nodes += line.node_count();
    edges += line.edge_count();
    vertices = std::max(vertices, line.opposite.cols());
    parts = parts || line.part.size() > 0;
  }
};

ContactLine room_for(const Extent& all) {
  ContactLine joined;
  joined.vertex.resize(all.nodes);
  joined.normal.resize(2, all.nodes);
  joined.abscissa.resize(all.nodes);
  joined.edge_node.resize(2, all.edges);
  joined.edge.resize(all.edges);
  joined.length.resize(all.edges);
  if (all.parts) joined.part = Vector2d(0, 1).replicate(1, all.edges);
  if (all.vertices > 0) joined.opposite_edge.setConstant(all.edges, -1);
  return joined;
}

void put_nodes(const ContactLine& line, int first, ContactLine& joined) {
  const int count = line.node_count();
  joined.vertex.segment(first, count) = line.vertex;
  joined.normal.middleCols(first, count) = line.normal;
  joined.abscissa.segment(first, count) = line.abscissa;
  joined.precision = std::max(joined.precision, line.precision);
}

void put_edges(const ContactLine& line, const Extent& before,
               ContactLine& joined) {
  const int first = before.edges, count = line.edge_count();
  joined.edge_node.middleCols(first, count) =
      line.edge_node.array() + before.nodes;
  joined.edge.segment(first, count) = line.edge;
  joined.length.segment(first, count) = line.length;
  if (line.part.size() > 0) joined.part.middleCols(first, count) = line.part;
  if (line.against_a_body())
    joined.opposite_edge.segment(first, count) = line.opposite_edge;
}

void put_pieces(const ContactLine& line, int first_edge, ContactLine& joined) {
  for (FacingPiece piece : line.pieces) {
    piece.contact_edge += first_edge;
    joined.pieces.push_back(piece);
  }
}

void add_opposite(const ContactLine& line, int first_node, Triplets& entries) {
  for (int i = 0; i < line.node_count(); ++i)
    visit_opposite(line, i, [&](int vertex, double weight) {
      entries.emplace_back(first_node + i, vertex, weight);
    });
}

}  // namespace

ContactLine joined_lines(const std::vector<ContactLine>& lines) {
  Extent all, before;
  for (const ContactLine& line : lines) all.add(line);
  ContactLine joined = room_for(all);
  Triplets opposite;
  for (const ContactLine& line : lines) {
    put_nodes(line, before.nodes, joined);
    put_edges(line, before, joined);
    put_pieces(line, before.edges, joined);
    add_opposite(line, before.nodes, opposite);
    before.add(line);
  }
  if (all.vertices > 0)
    joined.opposite = packed<WeightsByNode>(all.nodes, all.vertices, opposite);
  return joined;
}

}  // namespace ffcontact
