// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/opposite_projection.hpp"

#include <cmath>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/plane.hpp"
#include "ffcontact/interface/line_ends.hpp"
#include "ffcontact/linear/sparse_lu.hpp"

namespace ffcontact {

namespace {

/// The values of the two linear functions of an edge at a place on it.
struct Hats {
  double value[2];
  explicit Hats(double place) : value{1 - place, place} {}
};

/// Takes the displacement of the own trace from D where it is not that of the nodes: the
/// density is constant on short ends of the line, but the trace is not.
void add_own_trace(const Edges& edges, const ContactLine& line,
                   Triplets& entries) {
  for (int e = 0; e < line.edge_count(); ++e) {
    if (!is_constant_on(line, e)) continue;
    const int node = line.edge_node(0, e);
    const double middle = 0.5 * (line.place(0, e) + line.place(1, e));
    const Hats own(middle);
    entries.emplace_back(node, line.vertex[node], line.length[e]);
    for (int k = 0; k < 2; ++k)
      entries.emplace_back(node, edges.vertices(k, line.edge[e]),
                           -line.length[e] * own.value[k]);
  }
}

/// Adds weight psi_a phi_b at a share s of the way along a piece.
void add_products(const Edges& edges, const ContactLine& line,
                  const FacingPiece& piece, double s, double weight,
                  Triplets& entries) {
  const int e = piece.contact_edge;
  const Hats psi(line.share(e, between(piece.begin, piece.end, s)));
  const Hats phi(between(piece.opposite_begin, piece.opposite_end, s));
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      entries.emplace_back(line.edge_node(a, e),
                           edges.vertices(b, piece.opposite_edge),
                           weight * psi.value[a] * phi.value[b]);
}

/// D_ij = int psi_i phi_j over the pieces, phi_j the hat functions of the opposite trace
/// [p x vertices]; two Gauss points are exact.
SparseMatrix coupling(const Mesh& mesh, const Edges& edges,
                      const ContactLine& line) {
  const double gauss = 0.5 / std::sqrt(3.0);
  Triplets entries;
  for (const FacingPiece& piece : line.pieces) {
    const int e = piece.contact_edge;
    const double share = line.share(e, piece.end) - line.share(e, piece.begin);
    const double weight = 0.5 * line.length[e] * share;
    add_products(edges, line, piece, 0.5 - gauss, weight, entries);
    add_products(edges, line, piece, 0.5 + gauss, weight, entries);
  }
  add_own_trace(edges, line, entries);
  return packed(line.node_count(), mesh.vertex_count(), entries);
}

/// What nodes between two vertices move less than the nearer one: at a share s of the way
/// to the other, s (u_near - u_other).
void add_shares_of_vertices(const Edges& edges, const ContactLine& line,
                            Triplets& entries) {
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) {
      const double place = line.place(end, e);
      if (place == 0 || place == 1 || is_constant_on(line, e)) continue;
      const int node = line.edge_node(end, e), near = place < 0.5 ? 0 : 1;
      const double share = near == 0 ? place : 1 - place;
      entries.emplace_back(node, edges.vertices(near, line.edge[e]), share);
      entries.emplace_back(node, edges.vertices(1 - near, line.edge[e]),
                           -share);
    }
}

/// The entries of M^-1 D, which decay by a factor of about four a node; those below
/// rounding are dropped.
Triplets projected(const SparseMatrix& M, const SparseMatrix& D) {
  constexpr double rounding = 1e-18;
  const SparseLu mass(M);
  Triplets entries;
  for (int j = 0; j < D.outerSize(); ++j) {
    if (D.col(j).nonZeros() == 0) continue;
    const VectorXd column = mass.solve(VectorXd(D.col(j)));
    for (Index i = 0; i < column.size(); ++i)
      if (std::abs(column[i]) > rounding)
        entries.emplace_back(static_cast<int>(i), j, column[i]);
  }
  return entries;
}

WeightsByNode projection(const Mesh& mesh, const Edges& edges,
                         const ContactLine& line) {
  Triplets entries = projected(contact_mass(line), coupling(mesh, edges, line));
  add_shares_of_vertices(edges, line, entries);
  return packed<WeightsByNode>(line.node_count(), mesh.vertex_count(), entries);
}

WeightsByNode facing_vertices(const Mesh& mesh, const Edges& edges,
                              const ContactLine& line) {
  Triplets entries;
  for (const FacingPiece& piece : line.pieces)
    for (int end = 0; end < 2; ++end)
      entries.emplace_back(line.edge_node(end, piece.contact_edge),
                           edges.vertices(1 - end, piece.opposite_edge), 1.0);
  WeightsByNode Pi(line.node_count(), mesh.vertex_count());
  Pi.setFromTriplets(entries.begin(), entries.end(),
                     [](double first, double) { return first; });
  return Pi;
}

/// Is what faces an edge one whole edge, and what faces a node one vertex?
bool is_faced_one_by_one(const Edges& edges, const ContactLine& line) {
  std::vector<int> faced(line.node_count(), -1);
  for (const FacingPiece& piece : line.pieces)
    for (int end = 0; end < 2; ++end) {
      int& known = faced[line.edge_node(end, piece.contact_edge)];
      const int vertex = edges.vertices(1 - end, piece.opposite_edge);
      if (!piece.is_whole() || (known >= 0 && known != vertex)) return false;
      known = vertex;
    }
  return true;
}

}  // namespace

ContactLine with_opposite(const Mesh& mesh, const Edges& edges,
                          ContactLine line) {
  line.opposite_edge = VectorXi::Constant(line.edge_count(), -1);
  const bool matches = is_faced_one_by_one(edges, line);
  line.opposite = matches ? facing_vertices(mesh, edges, line)
                          : projection(mesh, edges, line);
  if (!matches) return line;
  for (const FacingPiece& piece : line.pieces)
    line.opposite_edge[piece.contact_edge] = piece.opposite_edge;
  return line;
}

}  // namespace ffcontact
