// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/symmetric_product.hpp"

#include <limits>

#include "support/random.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Its upper triangle is not read.
MatrixXd random_lower(Index n, std::mt19937& random) {
  MatrixXd S = random_matrix(n, n, random);
  S.triangularView<Eigen::StrictlyUpper>().setConstant(
      std::numeric_limits<double>::quiet_NaN());
  return S;
}

RC_GTEST_PROP(SymmetricProduct, is_that_of_both_triangles, (Random random)) {
  const Index n = *rc::gen::inRange(0, 100);
  const MatrixXd S = random_lower(n, random);
  const VectorXd x = random_vector(n, random),
                 expected = S.selfadjointView<Eigen::Lower>() * x;
  RC_ASSERT((symmetric_product(S, x) - expected).norm() <= 1e-13 * n);
}

/// More than one tile below each other.
TEST(SymmetricProduct, of_thousands_of_rows) {
  const Index n = 2100;
  std::mt19937 random;
  const MatrixXd S = random_lower(n, random);
  const VectorXd x = random_vector(n, random),
                 expected = S.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((symmetric_product(S, x) - expected).norm(),
            1e-13 * expected.norm());
}

TEST(SymmetricProduct, has_the_same_digits_for_any_number_of_threads) {
  std::mt19937 random;
  const MatrixXd S = random_lower(500, random);
  const VectorXd x = random_vector(500, random);
  const auto product = [&] { return symmetric_product(S, x); };
  EXPECT_EQ(on_threads(2, product), on_threads(1, product));
}

}  // namespace
}  // namespace ffcontact
