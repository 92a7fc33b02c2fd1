// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/boundary_springs.hpp"

#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/symmetric_eigen.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"

namespace ffcontact {

namespace {

/// Stiffnesses below this part of the largest one at a point are none.
constexpr double negligible_stiffness = 1e-12;

bool answers(const SymmetricEigen& axes, int k) {
  return axes.values[k] > negligible_stiffness * axes.values[1];
}

/// The sum of f(stiffness) n n' over the axes n along which K answers.
template <class Function>
Matrix2d over_axes(const Matrix2d& K, Function&& f) {
  const SymmetricEigen axes = symmetric_eigen(K);
  Matrix2d sum = Matrix2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const Vector2d n = axes.vectors.col(k);
    if (answers(axes, k)) sum += f(axes.values[k]) * n * n.transpose();
  }
  return sum;
}

Matrix2d projector(const Matrix2d& K) {
  return over_axes(K, [](double) { return 1.0; });
}

/// K^-1 on its range.
Matrix2d flexibility(const Matrix2d& K) {
  return over_axes(K, [](double k) { return 1 / k; });
}

double column_length(const Mesh& mesh, Index column) {
  return (mesh.vertices.col(mesh.boundary(1, column)) -
          mesh.vertices.col(mesh.boundary(0, column)))
      .norm();
}

/// (1 - s) I, s I: a linear vector field at a point from its end values.
Matrix<double, 2, 4> between_ends(int point) {
  const double s = gauss_places[point];
  Matrix<double, 2, 4> hats;
  hats << (1 - s) * Matrix2d::Identity(), s * Matrix2d::Identity();
  return hats;
}

Vector4d end_displacements(const Mesh& mesh,
                           const Ref<const VectorXd>& displacement,
                           Index column) {
  const auto at_vertices = displacement.reshaped(2, displacement.size() / 2);
  return at_vertices(Eigen::all, mesh.boundary.col(column)).reshaped();
}

/// End values of a linear density from its moments.
Matrix4d density_matrix(double length) {
  Matrix4d densities;
  for (int k = 0; k < 4; ++k)
    densities.col(k) = density_of_moments(Vector4d::Unit(k), length);
  return densities;
}

/// @param with_rest  whether u_0 counts
Matrix4Xd moments_of_answers(const Mesh& mesh, const BoundarySprings& springs,
                             const Ref<const VectorXd>& displacement,
                             bool with_rest) {
  Matrix4Xd moments = Matrix4Xd::Zero(4, springs.stiffness.cols());
  for (Index b = 0; b < moments.cols(); ++b) {
    if (!springs.on(b)) continue;
    const Vector4d ends = end_displacements(mesh, displacement, b);
    for (int q = 0; q < 3; ++q) {
      Vector2d u = between_ends(q) * ends;
      if (with_rest) u -= springs.rest_at(q, b);
      moments.col(b) -= column_length(mesh, b) * gauss_weights[q] *
                        between_ends(q).transpose() *
                        (springs.stiffness_at(q, b) * u);
    }
  }
  return moments;
}

/// The same with the sign of K (u - u_0).
SpringError quadratic_form(const Mesh& mesh, const BoundarySprings& springs,
                           const Ref<const VectorXd>& displacement,
                           const Vector4d& moments, Index column, double sign) {
  const double length = column_length(mesh, column);
  const Matrix4d densities = density_matrix(length);
  const Vector4d ends = end_displacements(mesh, displacement, column);
  SpringError error;
  for (int q = 0; q < 3; ++q) {
    const Matrix2d K = springs.stiffness_at(q, column);
    const Matrix<double, 2, 4> t = between_ends(q) * densities;
    const Vector2d u = between_ends(q) * ends - springs.rest_at(q, column),
                   off = t * moments + sign * K * u;
    const Matrix2d weight = length * gauss_weights[q] * flexibility(K);
    error.H += t.transpose() * weight * t;
    error.g += t.transpose() * weight * off;
    error.before += off.dot(weight * off);
  }
  return error;
}

void require_stiffness(const Matrix2d& K, const Vector2d& rest,
                       const Vector2d& place) {
  if (!K.allFinite() || !rest.allFinite())
    refuse("the springs at ", in_words(place), " are not finite numbers");
  const Vector2d k = symmetric_eigen(K).values;
  if (k[0] < -negligible_stiffness * max_norm(k))
    refuse("the stiffness of the springs must not be negative; at ",
           in_words(place), " it is ", k[0], " in one direction");
}

}  // namespace

Matrix2d BoundarySprings::stiffness_at(int point, Index column) const {
  const Vector3d k = stiffness.block<3, 1>(3 * point, column);
  Matrix2d K;
  K << k[0], k[1], k[1], k[2];
  return K;
}

Matrix2d answered_directions(const Mesh& mesh, const BoundarySprings& springs,
                             Index column) {
  constexpr double parallel = 1e-9;
  const Matrix2d P = projector(springs.stiffness_at(0, column));
  for (int q = 1; q < 3; ++q)
    if (!(P - projector(springs.stiffness_at(q, column))).isZero(parallel))
      refuse("the springs on the boundary edge at ",
             in_words(mesh.place(mesh.boundary(0, column))),
             " answer other directions at one end than at the other: along "
             "each edge a stiffness must be zero or positive all the way");
  return P;
}

void require_valid(const Mesh& mesh, const BoundarySprings& springs) {
  if (springs.empty()) return;
  require_size("springs", springs.stiffness.cols(), mesh.boundary.cols());
  require_size("springs at rest", springs.rest.cols(), mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    for (int q = 0; q < 3; ++q)
      require_stiffness(springs.stiffness_at(q, b), springs.rest_at(q, b),
                        mesh.place(mesh.boundary(0, b)));
    answered_directions(mesh, springs, b);
  }
}

Matrix4Xd spring_moments(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement) {
  return moments_of_answers(mesh, springs, displacement, true);
}

Matrix4Xd spring_moment_changes(const Mesh& mesh,
                                const BoundarySprings& springs,
                                const Ref<const VectorXd>& displacement) {
  return moments_of_answers(mesh, springs, displacement, false);
}

SpringError spring_error(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement,
                         const Vector4d& moments, Index column) {
  return quadratic_form(mesh, springs, displacement, moments, column, 1);
}

SpringNorms spring_norms(const Mesh& mesh, const BoundarySprings& springs,
                         const Ref<const VectorXd>& displacement,
                         const Matrix4Xd& tractions) {
  SpringNorms norms{VectorXd::Zero(springs.stiffness.cols())};
  const auto square = [&](Index b, double sign) {
    return quadratic_form(mesh, springs, displacement, tractions.col(b), b,
                          sign)
        .before;
  };
  for (Index b = 0; b < norms.difference.size(); ++b) {
    if (!springs.on(b)) continue;
    norms.difference[b] = square(b, 1);
    norms.sum += square(b, -1);
  }
  return norms;
}

VectorXd boundary_forces(const Mesh& mesh, const Matrix4Xd& moments) {
  VectorXd forces = VectorXd::Zero(2 * mesh.vertices.cols());
  for (Index b = 0; b < moments.cols(); ++b)
    for (int k = 0; k < 2; ++k)
      forces.segment<2>(2 * mesh.boundary(k, b)) +=
          moments.block<2, 1>(2 * k, b);
  return forces;
}

void require_no_springs_in_contact(const Edges& edges, const ContactLine& line,
                                   const BoundarySprings& springs) {
  const auto require_none = [&](int edge) {
    if (springs.on(edges.boundary_index[edge]))
      refuse(
          "the springs are on the contact line, at the edge between vertices ",
          edges.vertices(0, edge), " and ", edges.vertices(1, edge),
          ": give them on other labels");
  };
  for (const int edge : line.edge) require_none(edge);
  for (const FacingPiece& piece : line.pieces)
    require_none(piece.opposite_edge);
}

}  // namespace ffcontact
