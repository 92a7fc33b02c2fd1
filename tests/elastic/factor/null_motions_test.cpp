// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/null_motions.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr int n = 8, k = 2;

/// Rows from 1 to 1e8, as of a soft body on a stiff one, and motions of size 1.
struct Held {
  VectorXd size;
  MatrixXd motions, S;
};

/// A stiffness that has none against its motions, but for what is added.
Held held_by_nothing(Random& random) {
  Held held{
      VectorXd::NullaryExpr(
          n, [](Index i) { return std::pow(10, 4 - static_cast<double>(i)); }),
      random_matrix(n, k, random).array() - 0.5,
      {}};
  const MatrixXd scaled = held.size.asDiagonal() * held.motions;
  const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(scaled).householderQ() *
                     MatrixXd::Identity(n, n);
  const MatrixXd across = Q.rightCols(n - k);
  held.S = held.size.asDiagonal() * across * across.transpose() *
           held.size.asDiagonal();
  return held;
}

/// S R, each row relative to its own terms.
double relative_forces(const MatrixXd& S, const MatrixXd& motions) {
  const MatrixXd terms = S.cwiseAbs() * motions.cwiseAbs();
  return (S * motions).cwiseAbs().cwiseQuotient(terms).maxCoeff();
}

RC_GTEST_PROP(NullMotions, have_no_forces_in_any_row, (Random random)) {
  const Held held = held_by_nothing(random);
  const VectorXd D = held.S.diagonal().cwiseSqrt();
  const MatrixXd noise = random_matrix(n, n, random),
                 rounded = held.S + 1e-8 * D.asDiagonal() *
                                        (noise + noise.transpose()) *
                                        D.asDiagonal();
  MatrixXd twice(n, 2 * k);
  twice << held.motions, held.motions;
  const MatrixXd S = without_stiffness_of(twice, rounded);
  RC_ASSERT(relative_forces(S, held.motions) < 1e-13);
  RC_ASSERT(S.isApprox(S.transpose(), 1e-14));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      RC_ASSERT(std::abs(S(i, j) - held.S(i, j)) < 1e-6 * D[i] * D[j]);
}

TEST(NullMotions, of_a_body_without_any_leave_its_stiffness) {
  std::mt19937 random;
  const MatrixXd S = random_matrix(3, 3, random);
  EXPECT_EQ(without_stiffness_of(MatrixXd(3, 0), S), S);
  EXPECT_EQ(
      without_stiffness_of(MatrixXd::Zero(3, 1), MatrixXd::Identity(3, 3)),
      MatrixXd::Identity(3, 3));
}

}  // namespace
}  // namespace ffcontact
