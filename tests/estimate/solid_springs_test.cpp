// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of solids on springs.
#include "support/solid_springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/nested_solids.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Any stiffness, uniform stress: with the position at rest from which they answer with it
/// the solution is exact.
RC_GTEST_PROP(SolidSprings, are_exact_for_linear_displacements,
              (Random random)) {
  SolidProblem problem(irregular_solid(random));
  const Vector3d strain(random_vector(1, random)[0],
                        random_vector(1, random)[0],
                        -1 - std::abs(random_vector(1, random)[0]));
  Vector6d voigt;
  voigt << 1e-3 * strain, 0, 0, 0;
  const Vector3d sigma =
      (isotropic<3>(13e3 * 0.2 / 0.72, 13e3 / 2.4) * voigt).head<3>();
  RC_PRE(sigma.z() < 0);
  const auto u = [&](const Vector3d& x) -> Vector3d {
    return 1e-3 * strain.cwiseProduct(x);
  };
  BoundarySprings<3> springs;
  const double scale = std::pow(10.0, *real(0, 6));
  for (int side : {low_x, high_x, low_y, high_y, high_z}) {
    Vector3d n = Vector3d::Zero();
    const int axis = side == low_x || side == high_x   ? 0
                     : side == low_y || side == high_y ? 1
                                                       : 2;
    n[axis] = side == low_x || side == low_y ? -1 : 1;
    const Vector3d t = sigma.cwiseProduct(n);
    if (side != high_z && random() % 3 == 0) {
      problem.load(side, t);
      continue;
    }
    const bool along_normal = side != high_z && random() % 2;
    const Matrix3d K = along_normal ? Matrix3d(scale * n * n.transpose())
                                    : random_stiffness(3, scale, random);
    const Vector3d stretch =
        along_normal ? Vector3d(t / scale) : Vector3d(K.inverse() * t);
    put_springs(
        problem.mesh, side,
        [&](const Vector3d& x) {
          return SolidSpring{K, u(x) + stretch};
        },
        springs);
  }
  assemble(springs, problem);
  const ContactSolution<3> solution = problem.solve();
  const Estimate<3> found = estimate(problem, solution, springs);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.relative < 1e-9);
}

/// A brick pressed on its foundation by springs of any rank at its top, held by others at
/// its side.
struct SprungBrick {
  Vector3i cells;
  Vector3d on_low_x, rest;
  Matrix3d at_top, at_side;

  BoundarySprings<3> springs_on(const SolidMesh& mesh) const {
    BoundarySprings<3> springs;
    put_springs(
        mesh, high_z,
        [&](const Vector3d&) {
          return SolidSpring{at_top, rest};
        },
        springs);
    put_springs(
        mesh, high_x,
        [&](const Vector3d&) {
          return SolidSpring{at_side, Vector3d::Zero()};
        },
        springs);
    return springs;
  }
  SolidProblem on(int ratio) const {
    SolidProblem problem(brick(ratio * cells, {2, 1, 1}));
    problem.load(low_x, on_low_x);
    assemble(springs_on(problem.mesh), problem);
    return problem;
  }
};

SprungBrick random_brick(Random& random) {
  const auto scale = [] { return std::pow(10.0, *real(1, 5)); };
  return {{2, 2, 2},
          random_vector(3, random),
          1e-3 * random_vector(3, random) - Vector3d(0, 0, 2e-3),
          random_stiffness(1 + static_cast<int>(random() % 3), scale(), random),
          random_stiffness(3, scale(), random)};
}

RC_GTEST_PROP(SolidSprings, are_a_part_of_the_error, (Random random)) {
  const SprungBrick brick = random_brick(random);
  const SolidProblem problem = brick.on(1);
  const ContactSolution<3> solution = problem.solve();
  const BoundarySprings<3> springs = brick.springs_on(problem.mesh);
  const Estimate<3> found = estimate(problem, solution, springs);
  RC_ASSERT(found.reason == "");
  RC_ASSERT(found.springs > 0);
  const double square =
      found.elastic * found.elastic + found.contact + found.springs;
  RC_ASSERT(std::abs(square - found.e * found.e) <= 1e-12 * square);
  RC_ASSERT(std::abs(found.local.norm() - found.relative) <=
            1e-9 * found.relative);
  const Estimate<3> before = estimate(problem, solution, springs, {0});
  RC_ASSERT(before.reason == "");
  RC_ASSERT(std::abs(before.e - found.history.front()) <= 1e-6 * before.e);
  RC_ASSERT(found.e < before.e);
}

/// e and |u - u_hat|, the energy of the springs with it, of a solution on a finer mesh.
struct Bounded {
  double e, distance;

  explicit Bounded(const SprungBrick& brick) {
    const SolidProblem coarse = brick.on(1), fine = brick.on(2);
    const Estimate<3> found =
        estimate(coarse, coarse.solve(), brick.springs_on(coarse.mesh));
    const VectorXd difference =
        fine.solve().displacement -
        on_finer_brick(found.displacement, brick.cells, 2);
    e = found.admissible ? found.e : 0;
    distance = std::sqrt(difference.dot(fine.A * difference));
  }
};

RC_GTEST_PROP(SolidSprings, error_is_bounded_with_their_energy,
              (Random random)) {
  const Bounded bounded(random_brick(random));
  RC_ASSERT(bounded.distance <= bounded.e);
}

/// Unless a body tilts on soft springs, where tractions that are linear on faces do not
/// reach the edge on which it stands.
TEST(SolidSprings, error_is_near_to_that_of_a_finer_mesh) {
  Matrix3d at_top = 2e3 * Matrix3d::Identity();
  at_top(0, 1) = at_top(1, 0) = 500;
  const SprungBrick brick{{3, 3, 3},
                          {0.5, 0.3, -0.4},
                          {2e-4, -1e-4, -1e-3},
                          at_top,
                          1e3 * Matrix3d::Identity()};
  const Bounded bounded(brick);
  RecordProperty("ratio", std::to_string(bounded.e / bounded.distance));
  EXPECT_LE(bounded.distance, bounded.e);
  EXPECT_LE(bounded.e, 2.5 * bounded.distance);
}

TEST(SolidSprings, that_are_stiff_are_judged_as_supports) {
  const auto judged = [](double k) {
    SolidProblem problem(brick({3, 3, 3}, {2, 1, 1}));
    problem.load(low_x, {1, 0.3, -0.2});
    const Vector3d rest(1e-4, 0, -3e-4);
    BoundarySprings<3> springs;
    if (k == 0) {
      problem.move(high_z, [&](const Vector3d&) { return rest; });
      return estimate(problem, problem.solve(), RelaxationSettings{100});
    }
    put_springs(
        problem.mesh, high_z,
        [&](const Vector3d&) {
          return SolidSpring{k * Matrix3d::Identity(), rest};
        },
        springs);
    assemble(springs, problem);
    return estimate(problem, problem.solve(), springs, RelaxationSettings{100});
  };
  const Estimate<3> held = judged(0), sprung = judged(1e9);
  EXPECT_TRUE(sprung.admissible) << sprung.reason;
  EXPECT_NEAR(sprung.e, held.e, 2e-3 * held.e);
  EXPECT_NEAR(sprung.relative, held.relative, 2e-3 * held.relative);
}

/// What a support prescribes on their face is none of theirs, and those inclined to it are
/// judged as they are.
TEST(SolidSprings, share_a_face_with_a_support) {
  const auto judged = [](const Matrix3d& K) {
    SolidProblem problem(brick({3, 2, 2}, {2, 1, 1}));
    problem.load(high_z, {-1, 0.4, -2});
    problem.guide(low_y, 1);
    BoundarySprings<3> springs;
    put_springs(
        problem.mesh, high_x,
        [&](const Vector3d&) {
          return SolidSpring{K, Vector3d::Zero()};
        },
        springs);
    assemble(springs, problem);
    problem.guide(high_x, 0);
    return estimate(problem, problem.solve(), springs);
  };
  const Estimate<3> all = judged(Vector3d(300, 40, 50).asDiagonal()),
                    some = judged(Vector3d(0, 40, 50).asDiagonal());
  EXPECT_TRUE(all.admissible && some.admissible);
  EXPECT_NEAR(all.e, some.e, 1e-6 * some.e);
  Matrix3d inclined = Vector3d(300, 40, 50).asDiagonal();
  inclined(0, 1) = inclined(1, 0) = 20;
  const Estimate<3> fixed = judged(inclined);
  EXPECT_TRUE(fixed.admissible) << fixed.reason;
  EXPECT_NEAR(fixed.e, some.e, 0.05 * some.e);  // nearly the same problem
}

TEST(SolidSprings, of_another_stiffness_are_refused_by_name) {
  SolidProblem problem(brick({2, 2, 2}, {1, 1, 1}));
  problem.load(low_x, {1, 0, -1});
  BoundarySprings<3> springs;
  put_springs(
      problem.mesh, high_z,
      [](const Vector3d&) {
        return SolidSpring{100 * Matrix3d::Identity(), Vector3d(0, 0, -1e-3)};
      },
      springs);
  assemble(springs, problem);
  const ContactSolution<3> solution = problem.solve();
  BoundarySprings<3> other = springs;
  other.stiffness *= 2;
  EXPECT_TRUE(says(refusal([&] { estimate(problem, solution, other); }),
                   "spring= is not that of A"));
  EXPECT_TRUE(says(refusal([&] { estimate(problem, solution); }),
                   "A is stiffer along the boundary"));
  BoundarySprings<3> in_contact = springs;
  put_springs(
      problem.mesh, low_z,
      [](const Vector3d&) {
        return SolidSpring{Matrix3d::Identity(), Vector3d::Zero()};
      },
      in_contact);
  EXPECT_TRUE(says(refusal([&] { estimate(problem, solution, in_contact); }),
                   "the springs are on the contact surface"));
}

}  // namespace
}  // namespace ffcontact
