// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The monomials m_i = xi^p eta^q with p + q <= 4: 1, xi, eta, xi^2, xi eta, eta^2, ...
constexpr int polynomial_count = 15;

/// Integrals on the reference triangle (0, 0), (1, 0), (0, 1) that all triangles share, for the
/// basis functions b = T m that are orthonormal in int (grad b_i . grad b_j + b_i b_j): the
/// monomials themselves would cost six digits. All are exact, int xi^p eta^q being
/// p! q! / (p + q + 2)!, and without units.
struct PolynomialBasis {
  using Products = Matrix<double, polynomial_count, polynomial_count>;

  Products basis;                                    ///< T
  std::array<std::array<Products, 2>, 2> gradients;  ///< int d_a b_i d_b b_j
  /// int (1 - s) b_i ds and int s b_i ds on the three edges
  Matrix<double, polynomial_count, 6> edges;
  /// load on b_i of f with unit moment at one vertex
  Matrix<double, polynomial_count, 3> body;
  Matrix<double, polynomial_count, 3> linear;  ///< coefficients of 1, xi, eta
};

/// Integrated once.
const PolynomialBasis& polynomial_basis();

/// grad m_i at a point, one a column.
Matrix<double, 2, polynomial_count> monomial_gradients(const Vector2d& xi);

}  // namespace ffcontact
