// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"
#include "ffcontact/mesh/edges.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Springs on the boundary, an elastic foundation: a displacement u is answered by the
/// traction
///     t = -K (u - u_0),   K symmetric and >= 0,
/// beside the given ones. K and u_0 are known at three Gauss points of each column of
/// Mesh::boundary, by which all integrals with K are taken, as FreeFEM's int1d does by
/// default.
struct BoundarySprings {
  /// (K_xx, K_xy, K_yy) at the points, from the first vertex of a column to its second
  /// [N/mm^3, 9 x boundary]; no columns: no springs
  Matrix<double, 9, Dynamic> stiffness;
  Matrix<double, 6, Dynamic> rest;  ///< u_0 there [mm]

  BoundarySprings() : stiffness(9, 0), rest(6, 0) {}
  /// None on so many columns.
  explicit BoundarySprings(Index columns)
      : stiffness(Matrix<double, 9, Dynamic>::Zero(9, columns)),
        rest(Matrix<double, 6, Dynamic>::Zero(6, columns)) {}

  bool empty() const { return stiffness.cols() == 0; }
  bool on(Index column) const {
    return !empty() && !stiffness.col(column).isZero(0);
  }
  Matrix2d stiffness_at(int point, Index column) const;
  Vector2d rest_at(int point, Index column) const {
    return rest.block<2, 1>(2 * point, column);
  }
};

/// Places of the Gauss points on (0, 1), (1 -+ sqrt(3/5))/2, and their weights.
constexpr double gauss_places[] = {0.1127016653792583, 0.5, 0.8872983346207417},
                 gauss_weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// The projector on what the springs of a column can answer: 0, n n' for springs along n
/// alone, or 1.
/// @throws std::invalid_argument  if that is not the same at all points
Matrix2d answered_directions(const Mesh& mesh, const BoundarySprings& springs,
                             Index column);

/// @throws std::invalid_argument  if sizes differ, K is not finite and >= 0, or its
///                                range differs along an edge
void require_valid(const Mesh& mesh, const BoundarySprings& springs);

/// @throws std::invalid_argument  if there are springs on an edge of the contact line, or
///                                one that it faces: their tractions and those of contact
///                                could not be told apart
void require_no_springs_in_contact(const Edges& edges, const ContactLine& line,
                                   const BoundarySprings& springs);

/// Moments of -K (u - u_0) at the two vertices of each column of Mesh::boundary [4 x
/// boundary, N/mm]; no columns without springs.
Matrix4Xd spring_moments(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement);

/// Of -K u: what they change by with u.
Matrix4Xd spring_moment_changes(const Mesh& mesh,
                                const BoundarySprings& springs,
                                const Ref<const VectorXd>& displacement);

/// The error of tractions t in the springs' law, and its change when the moments of t
/// change by x:
///     int (t + K (u - u_0))' K^-1 (t + K (u - u_0)) = x'H x + 2 g'x + before      [N/mm times mm],
/// K^-1 on what the springs answer. It is twice what the energy of the springs,
/// (u - u_0)'K (u - u_0) / 2, its conjugate t'K^-1 t / 2 and the work t'(u - u_0) sum up
/// to; with it in e^2 the bounds hold for the norms with the springs' energy.
struct SpringError {
  Matrix4d H = Matrix4d::Zero();
  Vector4d g = Vector4d::Zero();
  double before = 0;
};

/// @param moments  of t, linear along the edge, at the vertices of a column
SpringError spring_error(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement,
                         const Vector4d& moments, Index column);

/// What (2.11) and (2.12) take of the springs, with |t|^2 = int t' K^-1 t.
struct SpringNorms {
  VectorXd difference;  ///< |t + K (u - u_0)|^2 per column [N/mm times mm]
  double sum = 0;       ///< |t - K (u - u_0)|^2 in all
};

/// @param tractions  moments of t [4 x boundary]
SpringNorms spring_norms(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement,
                         const Matrix4Xd& tractions);

/// Moments at the vertices of the columns of Mesh::boundary as forces on all dofs [N/mm].
VectorXd boundary_forces(const Mesh& mesh, const Matrix4Xd& moments);

}  // namespace ffcontact
