// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/singular_values.hpp"

#include <gtest/gtest.h>

#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SingularValues, are_the_lengths_of_what_becomes_of_V,
              (Random random)) {
  const MatrixXd A = random_matrix(9, 4, random);
  const auto [values, V] = singular_values(A);
  const MatrixXd squares = values.array().square().matrix().asDiagonal();
  RC_ASSERT((V.transpose() * V - MatrixXd::Identity(4, 4)).norm() < 1e-13);
  RC_ASSERT((V.transpose() * A.transpose() * A * V - squares).norm() <
            1e-12 * A.squaredNorm());
  for (int k = 1; k < 4; ++k) RC_ASSERT(values[k] <= values[k - 1]);
}

RC_GTEST_PROP(SingularValues, are_as_small_as_rounding_beside_the_largest,
              (Random random)) {
  MatrixXd A = random_matrix(50, 3, random);
  A.col(2) = A.col(0) + A.col(1);
  RC_ASSERT(singular_values(A).values[2] < 1e-14 * A.norm());
}

RC_GTEST_PROP(SymmetricEigen, diagonalises_by_an_orthonormal_basis,
              (Random random)) {
  const MatrixXd B = random_matrix(6, 6, random), A = B + B.transpose();
  const auto [values, vectors] = symmetric_eigen(A);
  const MatrixXd diagonal = values.asDiagonal();
  RC_ASSERT((vectors.transpose() * vectors - MatrixXd::Identity(6, 6)).norm() <
            1e-13);
  RC_ASSERT((A * vectors - vectors * diagonal).norm() < 1e-13 * A.norm() * 6);
  for (int k = 1; k < 6; ++k) RC_ASSERT(values[k] >= values[k - 1]);
}

}  // namespace
}  // namespace ffcontact
