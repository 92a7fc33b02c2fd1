// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/iterative/gmres.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// 2 n I + a random matrix, without symmetry.
MatrixXf random_regular(Index n, Random& random) {
  const MatrixXd A = random_matrix(n, n, random) +
                     2.0 * static_cast<double>(n) * MatrixXd::Identity(n, n);
  return A.cast<float>();
}

double relative_residual(const MatrixXf& A, const VectorXf& b,
                         const VectorXf& x) {
  const VectorXd left =
      (b.cast<double>() - A.cast<double>() * x.cast<double>());
  return left.norm() / b.cast<double>().norm();
}

RC_GTEST_PROP(Gmres, solves_with_any_regular_preconditioner, (Random random)) {
  const Index n = *rc::gen::inRange(1, 40);
  const MatrixXf A = random_regular(n, random), M = random_regular(n, random);
  const VectorXf b = random_vector(n, random).cast<float>();
  const GmresResult result =
      gmres([&](const VectorXf& x) { return VectorXf(A * x); },
            [&](const VectorXf& x) { return VectorXf(M * x); }, b);
  RC_ASSERT(result.residual <= 1e-4);
  RC_ASSERT(relative_residual(A, b, result.x) < 2e-4);
  RC_ASSERT(result.steps <= n);
}

/// As many products as A M has eigenvalues.
TEST(Gmres, needs_a_step_for_each_eigenvalue) {
  const Index n = 30;
  VectorXf values(n);
  for (Index i = 0; i < n; ++i) values[i] = static_cast<float>(1 + i % 3);
  const auto scaled = [&](const VectorXf& x) {
    return VectorXf(values.cwiseProduct(x));
  };
  const auto same = [](const VectorXf& x) { return x; };
  const auto divided = [&](const VectorXf& x) {
    return VectorXf(x.cwiseQuotient(values));
  };
  const VectorXf b = VectorXf::Ones(n);
  EXPECT_EQ(gmres(scaled, same, b).steps, 3);
  EXPECT_EQ(gmres(scaled, divided, b).steps, 1);
  EXPECT_EQ(gmres(scaled, same, b, {1e-4, 2}).steps, 2);
  EXPECT_GT(gmres(scaled, same, b, {1e-4, 2}).residual, 1e-4);
  EXPECT_EQ(gmres(scaled, same, VectorXf::Zero(n)).x, VectorXf::Zero(n));
}

/// The residual that it tells is the one that x has, also where it stops early.
RC_GTEST_PROP(Gmres, tells_its_residual, (Random random)) {
  const Index n = *rc::gen::inRange(2, 40);
  const MatrixXf A = random_matrix(n, n, random).cast<float>();
  const VectorXf b = random_vector(n, random).cast<float>();
  const auto same = [](const VectorXf& x) { return x; };
  const GmresResult result =
      gmres([&](const VectorXf& x) { return VectorXf(A * x); }, same, b,
            {1e-2, static_cast<int>(n) / 2});
  RC_ASSERT(std::abs(relative_residual(A, b, result.x) - result.residual) <
            1e-3);
}

}  // namespace
}  // namespace ffcontact
