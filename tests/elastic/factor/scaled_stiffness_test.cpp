// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/scaled_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(ScaledStiffness, has_ones_on_its_diagonal) {
  const Problem problem = example_2(Multiplier::force, 0.5, 3);
  const ElasticSystem system = problem.system();
  const VectorXd R = inverse_roots(system);
  for (int dof = 0; dof < system.dof_count(); ++dof) {
    const double own = system.stiffness.coeff(dof, dof);
    if (system.prescribed[dof])
      EXPECT_EQ(R[dof], 1);
    else
      EXPECT_NEAR(R[dof] * R[dof] * own, 1, 1e-14);
  }
}

RC_GTEST_PROP(ScaledStiffness, of_a_schur_complement_is_taken_back,
              (Random random)) {
  const Index n = *rc::gen::inRange(1, 30);
  const MatrixXd S = random_matrix(n, n, random);
  const VectorXd R = random_vector(n, random).array().abs() + 0.1;
  const MatrixXd scaled = R.asDiagonal() * S * R.asDiagonal();
  RC_ASSERT((unscaled<double>(scaled, R) - S).norm() < 1e-13 * n);
  const Matrix<float, Dynamic, Dynamic> single = scaled.cast<float>();
  RC_ASSERT((unscaled<float>(single, R) - S).norm() < 1e-5 * n);
}

TEST(ScaledStiffness, places_are_the_inverse_of_an_order) {
  EXPECT_EQ(places({3, 0, 4}, 5), std::vector<int>({1, -1, -1, 0, 2}));
}

/// Three copies of k^2 numbers of 8 bytes in half of the memory.
TEST(ScaledStiffness, has_room_in_half_of_the_memory) {
  const auto said = [](double memory) {
    return refusal([&] { require_room_for_schur(1000, memory); });
  };
  EXPECT_EQ(said(48e6), "accepted");
  EXPECT_TRUE(says(said(47.9e6), "1000 free dofs where bodies may touch"));
}

TEST(ScaledStiffness, keeps_free_dofs_each_once) {
  const Problem problem = example_2(Multiplier::force, 0.5, 3);
  const ElasticSystem system = problem.system();  // symmetric at the right
  const int held = 2 * 3, count = system.dof_count();
  const auto said = [&](const std::vector<int>& kept) {
    return refusal([&] { required_kept(system, kept); });
  };
  ASSERT_TRUE(system.prescribed[held]);
  EXPECT_EQ(said({0, 1, held + 1}), "accepted");
  EXPECT_TRUE(says(said({0, held}), "kept dof 6 is prescribed"));
  EXPECT_TRUE(says(said({-1}), "kept dof -1"));
  EXPECT_TRUE(says(said({count}), "does not exist"));
  EXPECT_EQ(said({count - 1}), "accepted");
  EXPECT_TRUE(says(said({1, 0, 1}), "kept dof 1 is listed twice"));
  EXPECT_THROW(fail_as_singular(), std::runtime_error);
}

}  // namespace
}  // namespace ffcontact
