// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/polynomial_basis.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

namespace ffcontact {

namespace {

constexpr int monomials = polynomial_count;
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

long double integral_of_product(const Powers& m, const Powers& k) {
  return integral(m.p + k.p, m.q + k.q);
}

/// Derivative of monomial i along axis a as factor and powers.
std::pair<double, Powers> derivative(int i, int a) {
  const Powers m = exponents[i];
  return a == 0 ? std::make_pair(double(m.p), Powers{m.p - 1, m.q})
                : std::make_pair(double(m.q), Powers{m.p, m.q - 1});
}

/// int d_a m_i d_b m_j
LongColumns products_of_derivatives(int a, int b) {
  LongColumns products(monomials, monomials);
  for (int i = 0; i < monomials; ++i)
    for (int j = 0; j < monomials; ++j) {
      const auto [di, m] = derivative(i, a);
      const auto [dj, k] = derivative(j, b);
      products(i, j) = di * dj == 0 ? 0 : di * dj * integral_of_product(m, k);
    }
  return products;
}

/// int m_i m_j
LongColumns mass_matrix() {
  LongColumns mass(monomials, monomials);
  for (int i = 0; i < monomials; ++i)
    for (int j = 0; j < monomials; ++j)
      mass(i, j) = integral_of_product(exponents[i], exponents[j]);
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
      reference_cell<2>().cast<long double>();
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
LongColumns long_product(const LongColumns& A, const LongColumns& B) {
  return A.lazyProduct(B);
}

/// T', a basis function a column, by Gram and Schmidt.
LongColumns orthonormal_columns(const LongColumns& gram) {
  LongColumns columns = LongColumns::Identity(monomials, monomials);
  for (int i = 0; i < monomials; ++i) {
    LongColumn column = columns.col(i);
    for (int j = 0; j < i; ++j) {
      const LongColumn other = columns.col(j);
      column -= other.dot(long_product(gram, column).col(0)) * other;
    }
    columns.col(i) =
        column / std::sqrt(column.dot(long_product(gram, column).col(0)));
  }
  return columns;
}

PolynomialBasis integrated_basis() {
  const LongColumns gram = mass_matrix() + products_of_derivatives(0, 0) +
                           products_of_derivatives(1, 1);
  const LongColumns columns = orthonormal_columns(gram),
                    T = columns.transpose();
  PolynomialBasis result;
  result.basis = T.cast<double>();
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      result.gradients[a][b] =
          long_product(long_product(T, products_of_derivatives(a, b)), columns)
              .cast<double>();
  result.edges = long_product(T, edge_integrals()).cast<double>();
  result.body = long_product(T, body_integrals()).cast<double>();
  // m = gram T' b
  result.linear =
      long_product(gram, columns).topRows<3>().transpose().cast<double>();
  return result;
}

}  // namespace

const PolynomialBasis& polynomial_basis() {
  static const PolynomialBasis basis = integrated_basis();
  return basis;
}

Matrix<double, 2, polynomial_count> monomial_gradients(const Vector2d& xi) {
  const Point point = xi.cast<long double>();
  Matrix<double, 2, polynomial_count> gradients;
  for (int i = 0; i < monomials; ++i)
    for (int a = 0; a < 2; ++a) {
      const auto [factor, m] = derivative(i, a);
      gradients(a, i) = static_cast<double>(factor * monomial(m.p, m.q, point));
    }
  return gradients;
}

}  // namespace ffcontact
