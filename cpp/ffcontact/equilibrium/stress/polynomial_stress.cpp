// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/polynomial_stress.hpp"

#include <Eigen/LU>

#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/stress/polynomial_basis.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"
#include "ffcontact/linear/dense/products.hpp"

namespace ffcontact {

namespace {

constexpr int unknowns = 2 * polynomial_count;

/// Voigt strain of u grad' with engineering shear: strain = E(gradient) u.
Matrix<double, 3, 2> strain_operator(const Vector2d& gradient) {
  Matrix<double, 3, 2> E;
  E << gradient.x(), 0, 0, gradient.y(), gradient.y(), gradient.x();
  return E;
}

/// Adds p_ij times a block to each block of K.
void add_blocks(const PolynomialBasis::Products& p, const Matrix2d& block,
                MatrixXd& K) {
  for (int i = 0; i < polynomial_count; ++i)
    for (int j = 0; j < polynomial_count; ++j)
      K.block<2, 2>(2 * i, 2 * j) += p(i, j) * block;
}

/// int C eps(b_j e_d) : eps(b_i e_c), unknown 2 i + c.
MatrixXd stiffness_of(const Matrix2d& B, const Matrix3d& hooke) {
  const Matrix2d inverse = B.inverse();
  MatrixXd K = MatrixXd::Zero(unknowns, unknowns);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const Matrix2d block = transposed_product(
          strain_operator(inverse.row(a)),
          product(B.determinant() * hooke, strain_operator(inverse.row(b))));
      add_blocks(polynomial_basis().gradients[a][b], block, K);
    }
  return K;
}

using RigidMotions = Matrix<double, unknowns, 3>;

/// Translations and the rotation (-y, x) about x_0, scaled to the size of the triangle.
RigidMotions rigid_motions(const Matrix2d& B) {
  RigidMotions Z = RigidMotions::Zero();
  const auto& linear = polynomial_basis().linear;
  for (int i = 0; i < polynomial_count; ++i) {
    Z(2 * i, 0) = Z(2 * i + 1, 1) = linear(i, 0);
    for (int a = 0; a < 2; ++a)
      Z.block<2, 1>(2 * i, 2) +=
          linear(i, 1 + a) * Vector2d(-B(1, a), B(0, a)) / B.norm();
  }
  return Z;
}

using Coefficients = Matrix<double, 2, polynomial_count>;

VectorXd load_of(const FacetLoads<2>& on_edges,
                 const CellBodyLoads<2>& body_loads) {
  Coefficients load = Coefficients::Zero();
  for (int k = 0; k < 3; ++k) {
    // times the edge's length
    const Matrix2d density = facet_density<2>(on_edges.middleCols<2>(2 * k), 1);
    load += product(density,
                    polynomial_basis().edges.middleCols(2 * k, 2).transpose());
  }
  load += product(body_loads, polynomial_basis().body.transpose());
  return load.reshaped();
}

}  // namespace

PolynomialStress polynomial_stress(const CellCorners<2>& corners,
                                   const Matrix3d& hooke,
                                   const FacetLoads<2>& on_edges,
                                   const CellBodyLoads<2>& body_loads) {
  const Matrix2d B = piola_matrix(corners);
  MatrixXd K = stiffness_of(B, hooke);
  const RigidMotions Z = rigid_motions(B);
  // balanced loads: w without rigid motion solves both systems
  add_square(std::sqrt(K.trace() / unknowns) * Z, K);
  PolynomialStress stress{corners, hooke, {}};
  stress.displacement.reshaped() =
      Cholesky(K).solve(load_of(on_edges, body_loads));
  return stress;
}

Vector3d stress_at(const PolynomialStress& stress, const Vector2d& point) {
  const Matrix2d inverse = piola_matrix(stress.corners).inverse();
  const auto gradients =
      monomial_gradients(inverse * (point - stress.corners.col(0)));
  // on the monomials
  const Coefficients w = product(stress.displacement, polynomial_basis().basis);
  const MatrixXd slopes = product(w, gradients.transpose());
  Vector3d strain = Vector3d::Zero();
  for (int a = 0; a < 2; ++a)
    strain += product(strain_operator(inverse.row(a)), slopes.col(a));
  return stress.hooke * strain;
}

SubcellStress<2> corner_values(const PolynomialStress& stress) {
  SubcellStress<2> values;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 2; ++c)
      values.col(3 * k + c) =
          stress_at(stress, stress.corners.col((k + 1 + c) % 3));
    values.col(3 * k + 2) = stress_at(stress, stress.corners.rowwise().mean());
  }
  return values;
}

double energy(const PolynomialStress& stress, const Matrix3d& at_vertices) {
  const CellCorners<2>& corners = stress.corners;
  const Matrix2d B = piola_matrix(corners);
  const VectorXd w = stress.displacement.reshaped();
  // int s : eps(w), by parts
  const FacetLoads<2> loads = loads_of_stress(corners, at_vertices);
  const double work = load_of(loads, balancing_body_loads<2>(loads)).dot(w);
  return w.dot(stiffness_of(B, stress.hooke) * w) + 2 * work +
         energy(corners, stress.hooke.inverse(),
                subcell_values<2>(at_vertices));
}

}  // namespace ffcontact
