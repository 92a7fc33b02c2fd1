// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/conjugate_gradients.hpp"

#include <limits>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Eigenvalues from 1 to some n.
MatrixXd random_positive(Index n, Random& random) {
  const MatrixXd B = random_matrix(n, n, random);
  return B * B.transpose() + MatrixXd::Identity(n, n);
}

LinearMap product_with(const MatrixXd& A) {
  return [&A](const VectorXd& x) -> VectorXd { return A * x; };
}

RC_GTEST_PROP(ConjugateGradients, solves_with_any_positive_preconditioner,
              (Random random)) {
  const Index n = *rc::gen::inRange(1, 30);
  const MatrixXd A = random_positive(n, random), M = random_positive(n, random);
  const VectorXd b = random_vector(n, random);
  const auto x =
      conjugate_gradients(product_with(A), product_with(M), b, {1e-8, 500});
  RC_ASSERT(x.has_value());
  RC_ASSERT((b - A * *x).norm() <= 1.1e-8 * b.norm());
}

/// As many steps as M A has eigenvalues, and nothing by fewer.
TEST(ConjugateGradients, needs_a_step_for_each_eigenvalue) {
  const Index n = 30;
  VectorXd values(n);
  for (Index i = 0; i < n; ++i) values[i] = static_cast<double>(1 + i % 3);
  const auto scaled = [&](const VectorXd& x) -> VectorXd {
    return values.cwiseProduct(x);
  };
  const auto divided = [&](const VectorXd& x) -> VectorXd {
    return x.cwiseQuotient(values);
  };
  const auto same = [](const VectorXd& x) { return x; };
  const VectorXd b = VectorXd::Ones(n), zero = VectorXd::Zero(n);
  EXPECT_TRUE(conjugate_gradients(scaled, same, b, {1e-12, 3}));
  EXPECT_FALSE(conjugate_gradients(scaled, same, b, {1e-12, 2}));
  EXPECT_TRUE(conjugate_gradients(scaled, divided, b, {1e-12, 1}));
  EXPECT_EQ(conjugate_gradients(scaled, same, zero, {1e-12, 0}), zero);
}

TEST(ConjugateGradients, gives_nothing_where_a_number_is_not_finite) {
  const auto none = [](const VectorXd& x) -> VectorXd {
    return std::numeric_limits<double>::quiet_NaN() * x;
  };
  const auto same = [](const VectorXd& x) { return x; };
  const VectorXd b = VectorXd::Ones(3);
  EXPECT_FALSE(conjugate_gradients(none, same, b, {1e-2, 9}));
  EXPECT_FALSE(conjugate_gradients(same, none, b, {1e-2, 9}));
}

}  // namespace
}  // namespace ffcontact
