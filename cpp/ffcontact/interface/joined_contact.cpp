// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/joined_contact.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/appended.hpp"
#include "ffcontact/base/packed.hpp"

namespace ffcontact {

namespace {

/// Numbers of nodes that follow so many others; -1 stays none.
template <class Nodes>
Nodes behind(int others, const Nodes& nodes) {
  return (nodes.array() < 0).select(nodes, nodes.array() + others);
}

/// What faces facets that follow so many others.
template <class Piece>
void append_facing(const std::vector<Piece>& more, int Piece::*facet,
                   int others, std::vector<Piece>& all) {
  for (Piece piece : more) {
    piece.*facet += others;
    all.push_back(std::move(piece));
  }
}

/// part of a line some of which are not whole.
Matrix2Xd parts_of(const ContactLine& line) {
  return line.part.size() > 0
             ? line.part
             : Matrix2Xd(Vector2d(0, 1).replicate(1, line.edge_count()));
}

/// opposite_edge of a line that faces a body somewhere.
VectorXi opposite_edges(const ContactLine& line) {
  return line.opposite_edge.size() > 0
             ? line.opposite_edge
             : VectorXi::Constant(line.edge_count(), -1);
}

void append_entries(const SparseMatrix& matrix, Index first,
                    Triplets& entries) {
  for (Index j = 0; j < matrix.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
      entries.emplace_back(first + entry.row(), first + j, entry.value());
}

/// The matrix of two parts that have no entries in common.
SparseMatrix with_block(const SparseMatrix& first, const SparseMatrix& second) {
  Triplets entries;
  append_entries(first, 0, entries);
  append_entries(second, first.rows(), entries);
  const Index rows = first.rows() + second.rows();
  return packed(rows, rows, entries);
}

/// What facets have: of lines and of surfaces.
struct ContactFacets {
  static void append_parts(const ContactLine& line, ContactLine& all) {
    if (all.part.size() == 0 && line.part.size() == 0) return;
    all.part = parts_of(all);
    append(parts_of(line), all.part);
  }

  static void append_opposite_edges(const ContactLine& line, ContactLine& all) {
    if (all.opposite_edge.size() == 0 && line.opposite_edge.size() == 0) return;
    all.opposite_edge = opposite_edges(all);
    append(opposite_edges(line), all.opposite_edge);
  }

  static void append_to(const ContactLine& line, ContactLine& all) {
    append_facing(line.pieces, &FacingPiece::contact_edge, all.edge_count(),
                  all.pieces);
    append_parts(line, all);
    append_opposite_edges(line, all);
    append(behind(all.node_count(), line.edge_node), all.edge_node);
    append(line.edge, all.edge);
    append(line.length, all.length);
    append(line.abscissa, all.abscissa);
    all.precision = std::max(all.precision, line.precision);
  }

  static void append_to(const ContactSurface& surface, ContactSurface& all) {
    append_facing(surface.polygons, &FacingPolygon::contact_face,
                  all.face_count(), all.polygons);
    all.mass = with_block(all.mass, surface.mass);
    append(behind(all.node_count(), surface.face_node), all.face_node);
    append(surface.face, all.face);
    append(surface.area, all.area);
  }
};

}  // namespace

template <int d>
LineOrSurface<d> joined_contact(const std::vector<LineOrSurface<d>>& parts) {
  LineOrSurface<d> all;
  Triplets opposite;
  Index vertices = 0;
  for (const LineOrSurface<d>& part : parts) {
    for (int i = 0; i < part.node_count(); ++i)
      visit_opposite(part, i, [&](int vertex, double weight) {
        opposite.emplace_back(all.node_count() + i, vertex, weight);
      });
    vertices = std::max(vertices, part.opposite.cols());
    ContactFacets::append_to(part, all);
    append(part.vertex, all.vertex);
    append(part.normal, all.normal);
  }
  if (vertices > 0)
    all.opposite = packed<WeightsByNode>(all.node_count(), vertices, opposite);
  return all;
}

template LineOrSurface<FFCONTACT_DIMENSION> joined_contact<FFCONTACT_DIMENSION>(
    const std::vector<LineOrSurface<FFCONTACT_DIMENSION>>&);

}  // namespace ffcontact
