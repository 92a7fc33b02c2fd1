// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/face_quadratic.hpp"

#include <initializer_list>

namespace ffcontact {

namespace {

double factorial(int n) { return n > 1 ? n * factorial(n - 1) : 1; }

/// int of the product of some barycentric coordinates over the unit of area:
/// 2 a! b! c! / (a + b + c + 2)! with their exponents.
double integral_of(std::initializer_list<int> coordinates) {
  int exponent[3] = {0, 0, 0};
  for (const int k : coordinates) ++exponent[k];
  double product = 2;
  for (const int a : exponent) product *= factorial(a);
  return product / factorial(static_cast<int>(coordinates.size()) + 2);
}

}  // namespace

Matrix<double, 9, 9> products_of_places(const Matrix3d& P) {
  Matrix<double, 9, 9> products;
  for (int k = 0; k < 3; ++k)
    for (int a = 0; a < 3; ++a)
      products.block<3, 3>(3 * k, 3 * a) = P(k, a) * P;
  return products;
}

QuadraticOnFace raised(const Matrix3d& corners) {
  QuadraticOnFace r;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      r.col(3 * k + l) = 0.5 * (corners.col(k) + corners.col(l));
  return r;
}

const Matrix<double, 9, 3>& triple_products() {
  static const Matrix<double, 9, 3> products =
      Matrix<double, 9, 3>::NullaryExpr([](Index row, Index j) {
        const int kl = static_cast<int>(row);
        return integral_of({kl / 3, kl % 3, static_cast<int>(j)});
      });
  return products;
}

const Matrix<double, 9, 9>& fourfold_products() {
  static const Matrix<double, 9, 9> products =
      Matrix<double, 9, 9>::NullaryExpr([](Index row, Index column) {
        const int kl = static_cast<int>(row), mn = static_cast<int>(column);
        return integral_of({kl / 3, kl % 3, mn / 3, mn % 3});
      });
  return products;
}

}  // namespace ffcontact
