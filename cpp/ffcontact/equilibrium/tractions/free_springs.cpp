// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/free_springs.hpp"

#include <cmath>

#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Directions closer than this to an axis are that axis.
constexpr double on_axis = 1e-12;

bool is_diagonal(const Matrix2d& K) {
  return std::abs(K(0, 1)) <= on_axis * max_norm(K);
}

bool is_diagonal(const BoundarySprings& springs, Index column) {
  for (int q = 0; q < 3; ++q)
    if (!is_diagonal(springs.stiffness_at(q, column))) return false;
  return true;
}

/// Does an edge run as its column of Mesh::boundary?
bool runs_as_column(const Mesh& mesh, const Edges& edges, int edge) {
  return mesh.boundary(0, edges.boundary_index[edge]) ==
         edges.vertices(0, edge);
}

/// The same moments with the ends in the other order.
Vector4d ends_exchanged(const Vector4d& moments) {
  return {moments[2], moments[3], moments[0], moments[1]};
}

/// P at either end.
Matrix4d at_both_ends(const Matrix2d& P) {
  Matrix4d both = Matrix4d::Zero();
  both.topLeftCorner<2, 2>() = both.bottomRightCorner<2, 2>() = P;
  return both;
}

/// A form in the moments of a column in those of its edge, of which what P keeps.
SpringError of_edge(const SpringError& of_column, bool same_order,
                    const Matrix2d& P) {
  Matrix4d order = Matrix4d::Identity();
  if (!same_order) order << 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0;
  const MatrixXd keep = product(order, at_both_ends(P));
  return {congruent(of_column.H, keep), transposed_product(keep, of_column.g),
          of_column.before};
}

/// What springs answer and no support does.
Matrix2d free_directions(const Mesh& mesh, const BoundarySprings& springs,
                         Index column, bool x_known, bool y_known) {
  Matrix2d P = answered_directions(mesh, springs, column);
  if (x_known && y_known) return P;
  if (!is_diagonal(springs, column)) return Matrix2d::Zero();
  if (!x_known) P(0, 0) = 0;
  if (!y_known) P(1, 1) = 0;
  return P;
}

/// Directions of an edge that are known no longer.
void release(const FreeSpring& spring, BoundaryTractions& boundary) {
  const auto& [edge, P, error] = spring;
  auto known = boundary.known.col(edge);
  for (int c = 0; c < 2; ++c)
    if (P(c, c) > on_axis) known[c] = false;
  if (!is_diagonal(P)) {
    const Vector2d kept(1 - P(0, 0), -P(1, 0));
    boundary.known_direction[edge] = kept.normalized();
  }
}

}  // namespace

std::vector<FreeSpring> free_springs(const Mesh& mesh, const Edges& edges,
                                     const BoundarySprings& springs,
                                     const BoundaryTractions& boundary,
                                     const std::vector<int>& contact_edge,
                                     const Ref<const VectorXd>& displacement,
                                     const Matrix4Xd& tractions) {
  std::vector<FreeSpring> free;
  for (int e = 0; e < edges.count(); ++e) {
    const int b = edges.boundary_index[e];
    if (b < 0 || contact_edge[e] >= 0 || !springs.on(b)) continue;
    const Matrix2d P = free_directions(mesh, springs, b, boundary.known(0, e),
                                       boundary.known(1, e));
    if (P.isZero(0)) continue;
    const SpringError error =
        spring_error(mesh, springs, displacement, tractions.col(b), b);
    free.push_back({e, P, of_edge(error, runs_as_column(mesh, edges, e), P)});
  }
  return free;
}

BoundaryTractions released(BoundaryTractions boundary,
                           const std::vector<FreeSpring>& springs) {
  for (const FreeSpring& spring : springs) release(spring, boundary);
  return boundary;
}

std::vector<FacetTerm<2>> terms_of(const std::vector<FreeSpring>& springs) {
  std::vector<FacetTerm<2>> terms;
  for (const auto& [edge, answers, error] : springs)
    terms.push_back({edge, error.H, error.g, error.before});
  return terms;
}

void add_spring_changes(const Mesh& mesh, const Edges& edges,
                        const std::vector<FreeSpring>& springs,
                        const BoundaryTractions& boundary,
                        const EdgeMoments& moments, Matrix4Xd& tractions) {
  for (const auto& [edge, P, error] : springs) {
    const Vector4d change = moments.col(edge) - boundary.moments.col(edge);
    const Vector4d answered = at_both_ends(P) * change;
    tractions.col(edges.boundary_index[edge]) +=
        runs_as_column(mesh, edges, edge) ? answered : ends_exchanged(answered);
  }
}

}  // namespace ffcontact
