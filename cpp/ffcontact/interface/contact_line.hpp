// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/boundary_curves.hpp"
#include "ffcontact/interface/weights_by_node.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

/// A piece of the common refinement of two facing traces: the part (begin, end) of the
/// mesh edge of a contact edge and the part of the edge of the opposite body that it
/// faces, which runs the other way. Parameters go from 0 at the first to 1 at the second
/// vertex of their mesh edge; between the ends of a piece they correspond linearly.
struct FacingPiece {
  int contact_edge;                     ///< number on the contact line
  double begin, end;                    ///< begin < end
  int opposite_edge;                    ///< mesh edge
  double opposite_begin, opposite_end;  ///< opposite_begin > opposite_end
  /// distance along n at its ends, negative where the bodies overlap [mm]
  double gap_begin = 0, gap_end = 0;

  bool is_whole() const {
    return begin == 0 && end == 1 && opposite_begin == 1 && opposite_end == 0;
  }
};

/// The boundary part Gamma_C on which contact may occur, as a list of nodes that carry
/// multipliers.
///
/// Nodes follow t = (-n2, n1), counter-clockwise around the body; several separate lines
/// come one after the other, and closed ones start at a corner. Between
/// edges of one straight line neighbours share a node; a line is straight within the
/// precision of its coordinates, and has one normal, that of its chord. A vertex in which
/// two straight lines meet is two nodes, one for each line and its normal: multipliers
/// jump there, and the mass matrix (3.9) falls apart into one block per straight line.
/// The vertex then keeps clear of both lines, with W u as with W u_h on each of them: for
/// nodal forces both normal components of its displacement are bounded, for pressures
/// each end row of M is. On a polygon that stands for a smooth curve this would lock
/// sliding at every vertex; a line with curves, or of given directions (along_directions),
/// has one node a vertex instead.
///
/// Where the opposite body ends within a mesh edge so does the contact edge
/// (facing_line), at a node between the vertices.
struct ContactLine {
  /// mesh vertex of each node, or the nearer one of the two that it lies between [p]
  VectorXi vertex;
  Matrix2Xd normal;     ///< outward unit normal at each node [2 x p]
  VectorXd abscissa;    ///< arc length of each node [mm]
  Matrix2Xi edge_node;  ///< first and second node of each contact edge [2 x m]
  VectorXi edge;        ///< mesh edge of each contact edge [m]
  VectorXd length;      ///< of each contact edge [mm]
  /// places of the ends of contact edges on their mesh edges [2 x m]; empty where all are
  /// 0, 1
  Matrix2Xd part;
  /// of the coordinates of its vertices (coordinate_precision) [mm]
  double precision = 0;
  /// What is taken from the displacement of a node's vertex to give the jump [u] there,
  /// the same for both components [p x vertices]: the displacement of the opposite body,
  /// and at a node between two vertices what it moves less than its own. No rows where
  /// all of the foundation is rigid.
  WeightsByNode opposite;
  /// mesh edge that faces each contact edge as a whole, or -1 [m]; empty as `opposite`
  VectorXi opposite_edge;
  /// what the contact edges face, in their order; none on a rigid foundation
  std::vector<FacingPiece> pieces;

  int node_count() const { return static_cast<int>(vertex.size()); }
  int edge_count() const { return static_cast<int>(edge.size()); }
  bool against_a_body() const { return opposite.rows() > 0; }
  double place(int end, int e) const {
    return part.size() > 0 ? part(end, e) : end;
  }
  /// Share of a contact edge at a place on its mesh edge.
  double share(int e, double at) const {
    return (at - place(0, e)) / (place(1, e) - place(0, e));
  }
  /// Does every contact edge that faces another body face one whole edge, and every node
  /// one vertex? Not in front of a joint between two bodies.
  bool matches() const {
    return std::all_of(
        pieces.begin(), pieces.end(), [this](const FacingPiece& p) {
          return opposite_edge[p.contact_edge] == p.opposite_edge;
        });
  }
  Vector2d tangent(int node) const {
    return {-normal(1, node), normal(0, node)};
  }
  /// n and t at a node, one column each.
  Matrix2d frame(int node) const {
    Matrix2d columns;
    columns << normal.col(node), tangent(node);
    return columns;
  }
  /// Both nodes of a contact edge have the normal of its straight line, except on a line
  /// of given directions.
  Vector2d edge_normal(int e) const { return normal.col(edge_node(0, e)); }
  Vector2d edge_tangent(int e) const { return tangent(edge_node(0, e)); }
};

/// Whether contact directions turn along an edge, as on a smooth curve.
inline bool turns(const ContactLine& line, int edge) {
  return line.normal.col(line.edge_node(0, edge)) !=
         line.normal.col(line.edge_node(1, edge));
}

/// Polygons that stand for smooth curves have one node a vertex, with the curve's normals,
/// and a node together with the straight line that they go on from, with its normal.
/// @param curves  of the same boundary; none to take all of it for straight lines
/// @throws std::invalid_argument  if `labels` is empty or one of them is on no boundary
///                                edge of the body
ContactLine contact_line(const Mesh& mesh, const Edges& edges,
                         const std::vector<int>& labels,
                         const BoundaryCurves& curves = {});

/// One node a vertex, corners included, with the unit mean of the normals of the edges
/// beside it. For smooth curves.
/// @throws std::invalid_argument  as contact_line
ContactLine smooth_contact_line(const Mesh& mesh, const Edges& edges,
                                const std::vector<int>& labels);

/// The same nodes and edges with given contact directions in place of the normals: u_n,
/// u_t and the gap are measured along them, integrals stay on the geometric edges.
/// @param direction  of any length, pointing out of the body on the edges beside its node
///                   [2 x p]
/// @throws std::invalid_argument  naming the first vertex whose direction is zero, not
///                                finite, or points into the body
ContactLine along_directions(const Mesh& mesh, const Edges& edges,
                             ContactLine line,
                             const Ref<const Matrix2Xd>& direction);

/// Mass matrix on Gamma_C [mm], m_ij = int psi_i psi_j, tridiagonal [CHH01, (3.9)].
SparseMatrix contact_mass(const ContactLine& line);

/// [u] at a node, u less that of what it faces, of fields on all dofs, one column each
/// [2 x columns].
template <class Fields>
Matrix<double, 2, Fields::ColsAtCompileTime> jump_at(const ContactLine& line,
                                                     int node,
                                                     const Fields& fields) {
  Matrix<double, 2, Fields::ColsAtCompileTime> jump =
      fields.template middleRows<2>(2 * line.vertex[node]);
  visit_opposite(line, node, [&](int vertex, double weight) {
    jump -= weight * fields.template middleRows<2>(2 * vertex);
  });
  return jump;
}

/// Normal and tangential components at the nodes [2 x p] of a vertex field (2 * vertex +
/// component) against the opposite body: [u] . n and [u] . t for [u] = u - opposite u,
/// with u = 0 in a rigid foundation. [u] . n > 0 is penetration.
Matrix2Xd contact_components(const ContactLine& line,
                             const Ref<const VectorXd>& field);

}  // namespace ffcontact
