// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "ffcontact/linear/norms.hpp"

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

/// A linear vector field at a point from its end values.
Vector2d between_ends(int point, const Vector4d& ends) {
  const double s = gauss_places[point];
  return (1 - s) * ends.head<2>() + s * ends.tail<2>();
}

/// A vector at a point times the hat functions of the ends.
Vector4d at_ends(int point, const Vector2d& v) {
  const double s = gauss_places[point];
  return {(1 - s) * v.x(), (1 - s) * v.y(), s * v.x(), s * v.y()};
}

Vector4d end_displacements(const Mesh& mesh,
                           const Ref<const VectorXd>& displacement,
                           Index column) {
  const Vector2d first = vector_at<2>(displacement, mesh.boundary(0, column)),
                 second = vector_at<2>(displacement, mesh.boundary(1, column));
  return {first.x(), first.y(), second.x(), second.y()};
}

/// Its end values from its moments.
Vector4d density_of(const Vector4d& moments, double length) {
  return facet_density<2>(moments.reshaped(2, 2), length).reshaped();
}

/// The traction at a point from its moments, a column for each.
Matrix<double, 2, 4> tractions_at(int point, double length) {
  Matrix<double, 2, 4> tractions;
  for (int k = 0; k < 4; ++k)
    tractions.col(k) =
        between_ends(point, density_of(Vector4d::Unit(k), length));
  return tractions;
}

/// @param with_rest  whether u_0 counts
Matrix4Xd moments_of_answers(const Mesh& mesh, const BoundarySprings& springs,
                             const Ref<const VectorXd>& displacement,
                             bool with_rest) {
  Matrix4Xd moments = Matrix4Xd::Zero(4, springs.stiffness.cols());
  for (Index b = 0; b < moments.cols(); ++b) {
    if (!springs.on(b)) continue;
    const Vector4d ends = end_displacements(mesh, displacement, b);
    const double length = boundary_measure(mesh, b);
    for (int q = 0; q < 3; ++q) {
      Vector2d u = between_ends(q, ends);
      if (with_rest) u -= springs.rest_at(q, b);
      const double weight = length * gauss_weights[q];
      moments.col(b) -= at_ends(q, weight * (springs.stiffness_at(q, b) * u));
    }
  }
  return moments;
}

/// The same with the sign of K (u - u_0).
SpringError quadratic_form(const Mesh& mesh, const BoundarySprings& springs,
                           const Ref<const VectorXd>& displacement,
                           const Vector4d& moments, Index column, double sign) {
  const double length = boundary_measure(mesh, column);
  const Vector4d ends = end_displacements(mesh, displacement, column),
                 density = density_of(moments, length);
  SpringError error;
  for (int q = 0; q < 3; ++q) {
    const Matrix2d K = springs.stiffness_at(q, column);
    const Matrix<double, 2, 4> t = tractions_at(q, length);
    const Vector2d u = between_ends(q, ends) - springs.rest_at(q, column),
                   answer = K * u,
                   off = between_ends(q, density) + sign * answer;
    const Matrix2d weight = length * gauss_weights[q] * flexibility(K);
    const Vector2d weighted = weight * off;
    error.H += congruent(weight, t);
    error.g += transposed_product(t, weighted);
    error.before += off.dot(weighted);
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
