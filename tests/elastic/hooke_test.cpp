// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/hooke.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(Hooke, isotropic_is_lambda_trace_plus_two_G_strain) {
  const Vector3d strain(0.3, -0.2, 2 * 0.1);  // engineering shear
  const Vector3d expected(7 * 0.1 + 2 * 5 * 0.3, 7 * 0.1 - 2 * 5 * 0.2,
                          2 * 5 * 0.1);
  EXPECT_LT((isotropic(7, 5) * strain - expected).norm(), 1e-14);
}

RC_GTEST_PROP(Hooke, strain_of_a_linear_displacement_is_its_symmetric_gradient,
              (Random random)) {
  const Mesh mesh = irregular(3, 3, 3, 3, random);
  const Matrix2d grad = random_matrix(2, 2, random);
  const VectorXd u = nodal_values(
      mesh, [&](const Vector2d& x) -> Vector2d { return grad * x; });
  const Vector3d expected(grad(0, 0), grad(1, 1), grad(0, 1) + grad(1, 0));
  for (int t = 0; t < mesh.cell_count(); ++t)
    RC_ASSERT((strain(mesh, u, t) - expected).norm() < 1e-11);
}

TEST(Hooke, stresses_use_the_tensor_of_each_triangle) {
  const Mesh mesh = rectangle(1, 1, 1, 1);
  const Hooke hooke{isotropic(1, 1), isotropic(2, 3)};
  const VectorXd u =
      nodal_values(mesh, [](const Vector2d& x) { return Vector2d(x.x(), 0); });
  const Matrix3Xd stress = stresses(mesh, hooke, u);
  EXPECT_LT((stress.col(0) - Vector3d(3, 1, 0)).norm(), 1e-15);
  EXPECT_LT((stress.col(1) - Vector3d(8, 2, 0)).norm(), 1e-15);
}

TEST(Hooke, traction_is_stress_times_normal) {
  EXPECT_EQ(traction(Vector3d(1, 2, 3), Vector2d(4, 5)),
            Vector2d(1 * 4 + 3 * 5, 3 * 4 + 2 * 5));
}

TEST(Hooke, refuses_a_tensor_that_is_not_elliptic) {
  const auto refusal_of = [](const Matrix3d& C) {
    return refusal([&] { require_elliptic(Hooke{isotropic(1, 1), C}, 2); });
  };
  const std::string sentence =
      "Hooke's tensor on triangle 1 is not symmetric and positive definite";
  EXPECT_EQ(refusal_of(isotropic(1, 2)), "accepted");
  EXPECT_EQ(refusal_of(isotropic(1, 0)), sentence);
  EXPECT_EQ(refusal_of(isotropic(-3, 1)), sentence);
  EXPECT_EQ(refusal_of(isotropic(-1.5, 1)), sentence);
  EXPECT_EQ(refusal_of(isotropic(std::nan(""), 1)), sentence);
  EXPECT_EQ(refusal_of(isotropic(1, 1) +
                       0.1 * Vector3d::UnitX() * Eigen::RowVector3d::UnitY()),
            sentence);
}

TEST(Hooke, refuses_one_tensor_for_two_triangles) {
  EXPECT_EQ(refusal([] { require_elliptic(Hooke(1, isotropic(1, 1)), 2); }),
            "Hooke's tensor has 1 values where 2 are needed");
}

}  // namespace
}  // namespace ffcontact
