// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/free_springs.hpp"

#include <cmath>

#include "ffcontact/base/congruent.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/products.hpp"

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

/// Moments of an edge's traction by the unknowns (A / l0, A_x, A_y) at its first and at its
/// second vertex and dA/dn in its middle [4 x 7].
MatrixXd moments_of_unknowns(const AirySpace& space, int edge) {
  const Vector2d side = edge_vector(space.mesh, space.edges, edge);
  const double l = side.norm();
  const Vector2d s = side / l;
  MatrixXd moments(4, 7);
  for (int c = 0; c < 7; ++c) {
    const VectorXd x = VectorXd::Unit(7, c);
    const Vector2d at_i = x.segment<2>(1), at_j = x.segment<2>(4);
    const double A_i = space.length[space.edges.vertices(0, edge)] * x[0],
                 A_j = space.length[space.edges.vertices(1, edge)] * x[3];
    const double along = 1.5 * (A_j - A_i) / l - 0.25 * s.dot(at_i + at_j);
    const Vector2d in_middle = along * s + x[6] * turned_right(s);
    moments.col(c) = moments_of_gradients(at_i, in_middle, at_j);
  }
  return moments;
}

void add(const FreeSpring& spring, const AirySpace& space, AiryEnergy& energy) {
  const int t = space.edges.cells(0, spring.edge);
  const int k = side_number(space.edges, spring.edge, t);
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const MatrixXd M = moments_of_unknowns(space, spring.edge);
  const MatrixXd H = congruent(spring.error.H, M);
  const VectorXd g = transposed_product(M, spring.error.g);
  energy.own[i] += H.block<3, 3>(0, 0);
  energy.own[j] += H.block<3, 3>(3, 3);
  energy.next[i] += H.block<3, 3>(0, 3);
  energy.edge[k].col(1) += H.block<3, 1>(0, 6);
  energy.edge[k].col(2) += H.block<3, 1>(3, 6);
  energy.edge_own[k] += H(6, 6);
  energy.slope.at_vertices.col(i) += g.segment<3>(0);
  energy.slope.at_vertices.col(j) += g.segment<3>(3);
  energy.slope.on_edges[k] += g[6];
  energy.before += spring.error.before;
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

void add_springs(const std::vector<FreeSpring>& springs, StarSetting& setting) {
  for (const FreeSpring& spring : springs)
    add(spring, setting.space,
        setting.energies[setting.space.edges.cells(0, spring.edge)]);
}

void add_spring_changes(const Mesh& mesh, const Edges& edges,
                        const std::vector<FreeSpring>& springs,
                        const BoundaryTractions& boundary,
                        const LinearStresses& stresses,
                        const EdgeLoadsOfAll& difference,
                        Matrix4Xd& tractions) {
  for (const auto& [edge, P, error] : springs) {
    const Vector4d change =
        moments_beside(mesh, edges, edge, stresses, difference) -
        boundary.moments.col(edge);
    const Vector4d answered = at_both_ends(P) * change;
    tractions.col(edges.boundary_index[edge]) +=
        runs_as_column(mesh, edges, edge) ? answered : ends_exchanged(answered);
  }
}

}  // namespace ffcontact
