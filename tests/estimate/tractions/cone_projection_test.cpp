// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/cone_projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Coulomb's or Tresca's law, in every other case with a limit; or no friction.
FrictionCone cone_of_any_kind(std::mt19937& random) {
  const Uniform value{0.1, 1};
  FrictionCone cone;
  if (random() % 2) cone.cohesion = value(random);
  if (random() % 2) cone.friction = value(random);
  if (random() % 2) cone.limit = value(random);
  return cone;
}

bool is_in(const FrictionCone& cone, const Vector3d& r) {
  return r[0] <= 0 && r.tail<2>().norm() <= cone.bound(r[0]) + 1e-15;
}

RC_GTEST_PROP(ConeProjection, is_nearer_than_any_other_point_of_the_cone,
              (Random random)) {
  const FrictionCone cone = cone_of_any_kind(random);
  const Vector3d r = 2 * random_vector(3, random),
                 nearest = cone_projection(cone, r).point;
  RC_ASSERT(is_in(cone, nearest));
  if (is_in(cone, r)) RC_ASSERT((nearest - r).norm() < 1e-15);
  for (int k = 0; k < 50; ++k) {
    Vector3d other = 2 * random_vector(3, random);
    other[0] = -std::abs(other[0]);
    const double size = other.tail<2>().norm(), bound = cone.bound(other[0]);
    if (size > bound) other.tail<2>() *= bound / size;
    // the cone is convex: (r - Pi r) . (s - Pi r) <= 0
    RC_ASSERT((r - nearest).dot(other - nearest) <= 1e-14);
  }
}

RC_GTEST_PROP(ConeProjection, has_the_slope_of_differences, (Random random)) {
  const FrictionCone cone = cone_of_any_kind(random);
  const Vector3d r = 2 * random_vector(3, random), d = random_vector(3, random);
  constexpr double h = 1e-6;
  const auto at = [&](double t) -> Vector3d {
    return cone_projection(cone, r + t * d).point;
  };
  const Vector3d before = (at(0) - at(-h)) / h, after = (at(h) - at(0)) / h;
  RC_PRE((before - after).norm() < 1e-4);  // no kink
  RC_ASSERT((cone_projection(cone, r).slope * d - (before + after) / 2).norm() <
            1e-7);
}

RC_GTEST_PROP(ConeProjection, has_a_symmetric_slope_between_0_and_1,
              (Random random)) {
  const FrictionCone cone = cone_of_any_kind(random);
  Vector3d r = 2 * random_vector(3, random);
  if (random() % 4 == 0) r.tail<2>().setZero();
  const Matrix3d slope = cone_projection(cone, r).slope;
  RC_ASSERT((slope - slope.transpose()).norm() < 1e-15);
  const Vector3d values =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(slope).eigenvalues();
  RC_ASSERT(values.minCoeff() > -1e-14 && values.maxCoeff() < 1 + 1e-14);
}

/// On the side of Coulomb's cone, beyond its apex, and under a limit.
TEST(ConeProjection, of_known_points) {
  FrictionCone cone;
  cone.friction = 1;
  const auto is = [&](const Vector3d& r, const Vector3d& point) {
    return (cone_projection(cone, r).point - point).norm() < 1e-15;
  };
  EXPECT_TRUE(is({0, 2, 0}, {-1, 1, 0}));
  EXPECT_TRUE(is({3, 0, -1}, {0, 0, 0}));
  cone.limit = 0.5;
  EXPECT_TRUE(is({-2, 0, 7}, {-2, 0, 0.5}));
  EXPECT_TRUE(is({0, 0.8, 0.6}, {-0.5, 0.4, 0.3}));
}

}  // namespace
}  // namespace ffcontact
