// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/initial_stress.hpp"

#include <Eigen/LU>
#include <cmath>

#include "freefem/plane_values.hpp"

namespace ffcontact::plugin {

namespace {

constexpr int points = 7;  ///< of the quadrature

using AtPoints = Matrix<double, 3, points>;

const Fem2D::QuadratureFormular& quadrature() {
  return Fem2D::QuadratureFormular_T_5;
}

/// The hat functions at the points.
AtPoints hats() {
  AtPoints phi;
  for (int q = 0; q < points; ++q) {
    const double x = quadrature()[q].x, y = quadrature()[q].y;
    phi.col(q) << 1 - x - y, x, y;
  }
  return phi;
}

/// Weights of the points, in parts of the area.
Matrix<double, points, 1> weights() {
  Matrix<double, points, 1> weights;
  for (int q = 0; q < points; ++q) weights[q] = quadrature()[q].a;
  return weights;
}

/// Vertex values of the linear function nearest to values at the points: times these.
Matrix<double, points, 3> projection() {
  const AtPoints phi = hats();
  const Matrix<double, points, 3> weighted =
      weights().asDiagonal() * phi.transpose();
  return weighted * (phi * weighted).inverse();
}

/// Values of the components at the points of all triangles [points x triangles] each.
std::array<MatrixXd, 3> sampled(Stack stack, const VoigtExpression& expression,
                                const Fem2D::Mesh& fem_mesh) {
  std::array<MatrixXd, 3> values;
  for (int c = 0; c < 3; ++c)
    values[c] = at_quadrature_points(stack, expression[c], fem_mesh);
  return values;
}

AtPoints on_triangle(const std::array<MatrixXd, 3>& values, int t) {
  AtPoints tau;
  for (int c = 0; c < 3; ++c) tau.row(c) = values[c].col(t);
  return tau;
}

double square(const AtPoints& tau, const Matrix3d& hooke, double area) {
  const AtPoints strain = hooke.inverse() * tau;
  return area * tau.cwiseProduct(strain).colwise().sum().dot(weights());
}

}  // namespace

InitialStress initial_stress_of(Stack stack, const VoigtExpression& strain,
                                const VoigtExpression& stress,
                                const Hooke& hooke,
                                const Fem2D::Mesh& fem_mesh) {
  const auto eps0 = sampled(stack, strain, fem_mesh),
             sigma0 = sampled(stack, stress, fem_mesh);
  const AtPoints phi = hats();
  const Matrix<double, points, 3> to_vertices = projection();
  InitialStress result{Matrix<double, 9, Dynamic>(9, fem_mesh.nt), 0};
  double oscillation = 0;
  for (int t = 0; t < fem_mesh.nt; ++t) {
    const AtPoints tau =
        on_triangle(sigma0, t) - hooke[t] * on_triangle(eps0, t);
    const Matrix3d at_vertices = tau * to_vertices;
    result.at_vertices.col(t) = at_vertices.reshaped();
    oscillation += square(tau - at_vertices * phi, hooke[t], fem_mesh[t].area);
  }
  result.oscillation = std::sqrt(oscillation);
  return result;
}

}  // namespace ffcontact::plugin
