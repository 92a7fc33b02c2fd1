// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/polynomial_stress.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/equilibrium/linear_stress.hpp"

namespace ffcontact {

namespace {

constexpr int monomials = 15, unknowns = 2 * monomials;
using Products = Matrix<double, monomials, monomials>;
using LongColumn = Matrix<long double, monomials, 1>;
using LongColumns = Matrix<long double, monomials, Dynamic>;

struct Powers {
  int p, q;
};

/// 1, xi, eta, xi^2, xi eta, eta^2, ...
std::array<Powers, monomials> powers() {
  std::array<Powers, monomials> result{};
  int next = 0;
  for (int degree = 0; degree <= 4; ++degree)
    for (int q = 0; q <= degree; ++q) result[next++] = {degree - q, q};
  return result;
}

const std::array<Powers, monomials> exponents = powers();

using Point = Matrix<long double, 2, 1>;

/// xi^p eta^q; 0 for a negative power, which has the factor 0 in a derivative.
long double monomial(int p, int q, const Point& xi) {
  return p < 0 || q < 0 ? 0 : std::pow(xi.x(), p) * std::pow(xi.y(), q);
}

/// int xi^p eta^q over the reference triangle.
long double integral(int p, int q) {
  if (p < 0 || q < 0) return 0;
  long double value = 1;  // p! q! / (p + q + 2)!
  for (int k = 2; k <= q; ++k) value *= k;
  for (int k = p + 1; k <= p + q + 2; ++k) value /= k;
  return value;
}

/// Derivative of monomial i along axis a as factor and powers.
std::pair<double, Powers> derivative(int i, int a) {
  const Powers m = exponents[i];
  return a == 0 ? std::make_pair(double(m.p), Powers{m.p - 1, m.q})
                : std::make_pair(double(m.q), Powers{m.p, m.q - 1});
}

/// Integrals on the reference triangle that all triangles share, for the basis functions
/// b = T m that are orthonormal in int (grad b_i . grad b_j + b_i b_j): the monomials m
/// themselves would cost six digits.
struct Reference {
  Products basis;                                    ///< T
  std::array<std::array<Products, 2>, 2> gradients;  ///< int d_a b_i d_b b_j
  /// int (1 - s) b_i ds and int s b_i ds on the three edges
  Matrix<double, monomials, 6> edges;
  /// load on b_i of f with unit moment at one vertex
  Matrix<double, monomials, 3> body;
  Matrix<double, monomials, 3> linear;  ///< coefficients of 1, xi, eta
};

/// int d_a m_i d_b m_j
LongColumns products_of_derivatives(int a, int b) {
  LongColumns products(monomials, monomials);
  for (int i = 0; i < monomials; ++i)
    for (int j = 0; j < monomials; ++j) {
      const auto [di, m] = derivative(i, a);
      const auto [dj, k] = derivative(j, b);
      products(i, j) =
          di * dj == 0 ? 0 : di * dj * integral(m.p + k.p, m.q + k.q);
    }
  return products;
}

/// int m_i m_j
LongColumns mass_matrix() {
  LongColumns mass(monomials, monomials);
  for (int i = 0; i < monomials; ++i)
    for (int j = 0; j < monomials; ++j)
      mass(i, j) = integral(exponents[i].p + exponents[j].p,
                            exponents[i].q + exponents[j].q);
  return mass;
}

/// int phi_v m_i
LongColumns hat_integrals() {
  LongColumns hats(monomials, 3);
  for (int i = 0; i < monomials; ++i) {
    const auto [p, q] = exponents[i];
    hats(i, 1) = integral(p + 1, q);
    hats(i, 2) = integral(p, q + 1);
    hats(i, 0) = integral(p, q) - hats(i, 1) - hats(i, 2);
  }
  return hats;
}

LongColumn monomials_at(const Point& x) {
  LongColumn values;
  for (int i = 0; i < monomials; ++i)
    values[i] = monomial(exponents[i].p, exponents[i].q, x);
  return values;
}

/// Adds int (1 - s) m_i ds and int s m_i ds along a straight line to two columns, by Gauss
/// points that are exact up to degree 5.
void add_line_integrals(const Point& from, const Point& to, int first,
                        LongColumns& sums) {
  const long double root = std::sqrt(0.15L),
                    gauss[] = {0.5L - root, 0.5L, 0.5L + root};
  const long double weight[] = {5.0L / 18, 8.0L / 18, 5.0L / 18};
  for (int g = 0; g < 3; ++g) {
    const long double s = gauss[g];
    const LongColumn values = weight[g] * monomials_at((1 - s) * from + s * to);
    sums.col(first) += (1 - s) * values;
    sums.col(first + 1) += s * values;
  }
}

/// Those on the three edges.
LongColumns edge_integrals() {
  const Matrix<long double, 2, 3> vertex =
      reference_triangle().cast<long double>();
  LongColumns edges = LongColumns::Zero(monomials, 6);
  for (int k = 0; k < 3; ++k)
    add_line_integrals(vertex.col((k + 1) % 3), vertex.col((k + 2) % 3), 2 * k,
                       edges);
  return edges;
}

/// int f_v m_i of the f_v with unit moment at vertex v: int phi_v phi_w is (1 + delta) / 24,
/// and its inverse 24 delta - 6.
LongColumns body_integrals() {
  const LongColumns hats = hat_integrals();
  const LongColumn sum = hats.rowwise().sum();
  LongColumns body = 24 * hats;
  for (int v = 0; v < 3; ++v) body.col(v) -= 6 * sum;
  return body;
}

/// A B without the kernels of large products, which take seconds to compile.
LongColumns product(const LongColumns& A, const LongColumns& B) {
  return A.lazyProduct(B);
}

/// T', a basis function a column, by Gram and Schmidt.
LongColumns orthonormal_columns(const LongColumns& gram) {
  LongColumns columns = LongColumns::Identity(monomials, monomials);
  for (int i = 0; i < monomials; ++i) {
    LongColumn column = columns.col(i);
    for (int j = 0; j < i; ++j) {
      const LongColumn other = columns.col(j);
      column -= other.dot(product(gram, column).col(0)) * other;
    }
    columns.col(i) =
        column / std::sqrt(column.dot(product(gram, column).col(0)));
  }
  return columns;
}

Reference integrate_reference() {
  const LongColumns gram = mass_matrix() + products_of_derivatives(0, 0) +
                           products_of_derivatives(1, 1);
  const LongColumns columns = orthonormal_columns(gram),
                    T = columns.transpose();
  Reference result;
  result.basis = T.cast<double>();
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      result.gradients[a][b] =
          product(product(T, products_of_derivatives(a, b)), columns)
              .cast<double>();
  result.edges = product(T, edge_integrals()).cast<double>();
  result.body = product(T, body_integrals()).cast<double>();
  // m = gram T' b
  result.linear =
      product(gram, columns).topRows<3>().transpose().cast<double>();
  return result;
}

const Reference& reference() {
  static const Reference integrals = integrate_reference();
  return integrals;
}

/// Voigt strain of u grad' with engineering shear: strain = E(gradient) u.
Matrix<double, 3, 2> strain_operator(const Vector2d& gradient) {
  Matrix<double, 3, 2> E;
  E << gradient.x(), 0, 0, gradient.y(), gradient.y(), gradient.x();
  return E;
}

/// Adds p_ij times a block to each block of K.
void add_blocks(const Products& p, const Matrix2d& block, MatrixXd& K) {
  for (int i = 0; i < monomials; ++i)
    for (int j = 0; j < monomials; ++j)
      K.block<2, 2>(2 * i, 2 * j) += p(i, j) * block;
}

/// int C eps(b_j e_d) : eps(b_i e_c), unknown 2 i + c.
MatrixXd stiffness_of(const Matrix2d& B, const Matrix3d& hooke) {
  const Matrix2d inverse = B.inverse();
  MatrixXd K = MatrixXd::Zero(unknowns, unknowns);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const Matrix2d block = B.determinant() *
                             strain_operator(inverse.row(a)).transpose() *
                             hooke * strain_operator(inverse.row(b));
      add_blocks(reference().gradients[a][b], block, K);
    }
  return K;
}

using RigidMotions = Matrix<double, unknowns, 3>;

/// Translations and the rotation (-y, x) about x_0, scaled to the size of the triangle.
RigidMotions rigid_motions(const Matrix2d& B) {
  RigidMotions Z = RigidMotions::Zero();
  const auto& linear = reference().linear;
  for (int i = 0; i < monomials; ++i) {
    Z(2 * i, 0) = Z(2 * i + 1, 1) = linear(i, 0);
    for (int a = 0; a < 2; ++a)
      Z.block<2, 1>(2 * i, 2) +=
          linear(i, 1 + a) * Vector2d(-B(1, a), B(0, a)) / B.norm();
  }
  return Z;
}

using Coefficients = Matrix<double, 2, monomials>;

VectorXd load_of(const EdgeLoads& on_edges, const BodyLoads& body_loads) {
  Coefficients load = Coefficients::Zero();
  for (int k = 0; k < 3; ++k) {
    // times the edge's length
    const Vector4d density = density_of_moments(on_edges.segment<4>(4 * k), 1);
    for (int end = 0; end < 2; ++end)
      load += density.segment<2>(2 * end) *
              reference().edges.col(2 * k + end).transpose();
    load += body_loads.segment<2>(2 * k) * reference().body.col(k).transpose();
  }
  return load.reshaped();
}

}  // namespace

PolynomialStress polynomial_stress(const TriangleCorners& corners,
                                   const Matrix3d& hooke,
                                   const EdgeLoads& on_edges,
                                   const BodyLoads& body_loads) {
  const Matrix2d B = piola_matrix(corners);
  MatrixXd K = stiffness_of(B, hooke);
  const RigidMotions Z = rigid_motions(B);
  // balanced loads: w without rigid motion solves both systems
  K += K.trace() / unknowns * Z * Z.transpose();
  PolynomialStress stress{corners, hooke, {}};
  stress.displacement.reshaped() =
      Cholesky(K).solve(load_of(on_edges, body_loads));
  return stress;
}

Vector3d stress_at(const PolynomialStress& stress, const Vector2d& point) {
  const Matrix2d inverse = piola_matrix(stress.corners).inverse();
  const Vector2d xi = inverse * (point - stress.corners.col(0));
  // on the monomials
  const Coefficients w = stress.displacement * reference().basis;
  Vector3d strain = Vector3d::Zero();
  for (int i = 0; i < monomials; ++i)
    for (int a = 0; a < 2; ++a) {
      const auto [factor, m] = derivative(i, a);
      const auto value = static_cast<double>(
          factor * monomial(m.p, m.q, xi.cast<long double>()));
      strain += value * strain_operator(inverse.row(a)) * w.col(i);
    }
  return stress.hooke * strain;
}

CompositeStress corner_values(const PolynomialStress& stress) {
  CompositeStress values;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 2; ++c)
      values.col(3 * k + c) =
          stress_at(stress, stress.corners.col((k + 1 + c) % 3));
    values.col(3 * k + 2) = stress_at(stress, stress.corners.rowwise().mean());
  }
  return values;
}

double energy(const PolynomialStress& stress, const Matrix3d& at_vertices) {
  const TriangleCorners& corners = stress.corners;
  const Matrix2d B = piola_matrix(corners);
  const VectorXd w = stress.displacement.reshaped();
  // int s : eps(w), by parts
  const double work = load_of(edge_loads(corners, at_vertices),
                              balancing_loads(corners, at_vertices))
                          .dot(w);
  return w.dot(stiffness_of(B, stress.hooke) * w) + 2 * work +
         energy(corners, stress.hooke.inverse(), composite_of(at_vertices));
}

}  // namespace ffcontact
