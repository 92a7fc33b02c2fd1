// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of bodies on springs.
#include "support/springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/nested_reference.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material soft = material(1000, 0.3);

Matrix2d along(const Vector2d& n, double k) { return k * n * n.transpose(); }

Matrix2d random_stiffness(Random& random) {
  const Matrix2d root = random_matrix(2, 2, random);
  return 100 * root * root.transpose() + Matrix2d::Identity();
}

/// A block on a frictionless foundation, pressed by springs at its top that are d too
/// long: p = k d / (1 + k h / E'), E' = E / (1 - nu^2).
TEST(Springs, that_press_a_block_uniformly_are_exact) {
  constexpr double k = 30, d = 0.1, height = 4;
  const double modulus = 1000 / (1 - 0.3 * 0.3);
  const double pressure = k * d / (1 + k * height / modulus);
  for (Multiplier multiplier : both_multipliers) {
    Random random(5);
    Problem problem = body(irregular(5, 4, 6, height, random), soft);
    prescribe(problem, left, 0);
    problem.law.multiplier = multiplier;
    BoundarySprings<2> springs;
    put_springs(
        problem.mesh, top,
        [&](const Vector2d&, const Vector2d& n) {
          return Spring{along(n, k), {7, -d}};
        },
        springs);
    assemble(springs, problem);
    const ContactSolution<2> solution = solved(problem);
    EXPECT_LT((solution.pressure.row(0).array() + pressure).abs().maxCoeff(),
              1e-9 * pressure);
    const Estimate<2> estimate = estimated(problem, solution, springs);
    EXPECT_TRUE(estimate.admissible) << estimate.reason;
    EXPECT_LT(estimate.relative, 1e-11);
    // |sigma_hat + C eps|^2 is four times the body's, the springs' sum likewise
    const double energy =
        4 * 6 *
        (height * pressure * pressure / modulus + pressure * pressure / k);
    EXPECT_NEAR(std::pow(estimate.e / estimate.relative, 2), energy,
                1e-9 * energy);
  }
}

/// Any stiffness, any position at rest, any uniform stress: with the tractions that they
/// miss the solution is exact.
RC_GTEST_PROP(Springs, are_exact_for_linear_displacements, (Random random)) {
  const Mesh mesh =
      irregular(*rc::gen::inRange(2, 6), *rc::gen::inRange(2, 5), 6, 4, random);
  const double p = *real(0.1, 10);
  // u_y = 0 at the bottom and no shear there
  const Vector3d strain(random_vector(1, random)[0], -p, 0);
  const Field u = [&](const Vector2d& x) {
    return Vector2d(strain[0] * x.x(), strain[1] * x.y());
  };
  const Vector3d sigma = soft.hooke() * strain;
  RC_PRE(sigma[1] < 0);
  Problem problem = body(mesh, soft);
  BoundarySprings<2> springs;
  for (const int label : {left, top, right}) {
    const Matrix2d K = random_stiffness(random);
    const Vector2d rest = random_vector(2, random);
    const bool is_normal = label == top && *rc::gen::arbitrary<bool>();
    put_springs(
        mesh, label,
        [&](const Vector2d&, const Vector2d& n) {
          return Spring{is_normal ? along(n, 50) : K, rest};
        },
        springs);
  }
  assemble(springs, problem);
  // F = sigma n + K (u - u_0), linear along the edges
  problem.neumann = -spring_moments<2>(mesh, springs, nodal_values(mesh, u));
  for (int e = 0; e < problem.edges.count(); ++e) {
    const int b = problem.edges.boundary_index[e];
    if (b < 0 || mesh.boundary_label[b] == bottom) continue;
    const Vector2d across = turned_right(edge_vector(mesh, problem.edges, e));
    problem.neumann.col(b) += 0.5 * traction(sigma, across).replicate<2, 1>();
  }
  problem.b += boundary_forces<2>(mesh, problem.neumann);
  const ContactSolution<2> solution = solved(problem);
  RC_ASSERT(solution.status == ContactStatus::converged);
  const Estimate<2> estimate = estimated(problem, solution, springs);
  RC_ASSERT(estimate.admissible);
  RC_ASSERT(estimate.relative < 1e-10);
}

/// A block pressed and sheared by springs at its top, or held sideways by some.
struct SprungBlock {
  Mesh mesh;
  Vector2d on_left, rest;
  Matrix2d at_top;
  double at_right, slip_bound, nu;
  Multiplier multiplier;

  BoundarySprings<2> springs_on(const Mesh& body_mesh) const {
    BoundarySprings<2> springs;
    put_springs(
        body_mesh, top,
        [&](const Vector2d&, const Vector2d&) {
          return Spring{at_top, rest};
        },
        springs);
    put_springs(
        body_mesh, right,
        [&](const Vector2d&, const Vector2d& n) {
          return Spring{along(n, at_right), Vector2d::Zero()};
        },
        springs);
    return springs;
  }
  Problem on(const Mesh& body_mesh) const {
    Problem problem = body(body_mesh, material(1e3, nu));
    add_traction(problem, left, on_left);
    assemble(springs_on(body_mesh), problem);
    problem.law.multiplier = multiplier;
    if (slip_bound > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound);
    return problem;
  }
};

SprungBlock random_sprung_block(Random& random, double stiffest = 3) {
  const Mesh mesh =
      irregular(*rc::gen::inRange(2, 5), *rc::gen::inRange(2, 4), 6, 4, random);
  const Vector2d on_left = random_vector(2, random) * 3,
                 rest = random_vector(2, random) * 0.02 - Vector2d(0, 0.03);
  const double scale = std::pow(10.0, *real(-2, stiffest));
  return {mesh,
          on_left,
          rest,
          scale * random_stiffness(random),
          std::pow(10.0, *real(0, stiffest)),
          *rc::gen::element(0.0, 2.0),
          *real(0, 0.4),
          *rc::gen::element(Multiplier::force, Multiplier::pressure)};
}

/// int (t - t')' K^-1 (t - t') + (u - u')' K (u - u') over the springs, of a solution on a
/// mesh whose edges are parts of those of the estimate's.
double squared_spring_distance(const SprungBlock& block, const Problem& coarse,
                               const Estimate<2>& estimate,
                               const Matrix4Xd& tractions, const Problem& fine,
                               const VectorXd& reference) {
  const BoundarySprings<2> springs = block.springs_on(coarse.mesh);
  const Index parts = fine.mesh.boundary.cols() / coarse.mesh.boundary.cols();
  double square = 0;
  for (Index b = 0; b < fine.mesh.boundary.cols(); ++b) {
    const Index B = b / parts;
    if (!springs.on(B)) continue;
    const auto end = [&](const Problem& problem, int k, Index column) {
      return Vector2d(
          problem.mesh.vertices.col(problem.mesh.boundary(k, column)));
    };
    const Vector2d from = end(coarse, 0, B), to = end(coarse, 1, B);
    const double length = (to - from).norm();
    const Vector4d density = density_of(tractions.col(B), length);
    for (int q = 0; q < 3; ++q) {
      const double s = FacetQuadrature<2>::hats(q)[1];
      const Vector2d x = (1 - s) * end(fine, 0, b) + s * end(fine, 1, b);
      const double S = (x - from).norm() / length;
      const auto value = [&](const Problem& problem, const VectorXd& u,
                             Index column, double share) -> Vector2d {
        return (1 - share) *
                   u.segment<2>(2 * problem.mesh.boundary(0, column)) +
               share * u.segment<2>(2 * problem.mesh.boundary(1, column));
      };
      const Matrix2d K = springs.stiffness_at(0, B);
      const Vector2d u = value(fine, reference, b, s),
                     u_hat = value(coarse, estimate.displacement, B, S);
      const Vector2d t = -K * (u - springs.rest_at(0, B)),
                     t_hat =
                         (1 - S) * density.head<2>() + S * density.tail<2>();
      const Matrix2d flexibility =
          K.completeOrthogonalDecomposition().pseudoInverse();
      square += length / static_cast<double>(parts) *
                FacetQuadrature<2>::weights[q] *
                ((t - t_hat).dot(flexibility * (t - t_hat)) +
                 (u - u_hat).dot(K * (u - u_hat)));
    }
  }
  return square;
}

/// (2.20) with the energy of the springs, for frictionless contact and Tresca's law.
RC_GTEST_PROP(Springs, error_is_bounded_with_their_energy, (Random random)) {
  const SprungBlock block = random_sprung_block(random);
  const Problem coarse = block.on(block.mesh),
                fine = block.on(subdivided(block.mesh, 3));
  const ContactSolution<2> solution = solved(coarse), reference = solved(fine);
  RC_ASSERT(solution.status == ContactStatus::converged);
  const Estimate<2> estimate =
      estimated(coarse, solution, block.springs_on(coarse.mesh),
                sweeps(*rc::gen::inRange(0, 4)));
  RC_ASSERT(estimate.admissible);
  const SquaredDistances body =
      squared_distances(coarse, estimate, fine, reference.displacement);
  const double springs = squared_spring_distance(block, coarse, estimate,
                                                 estimate.spring_tractions,
                                                 fine, reference.displacement);
  const double square = body.stress + body.displacement + springs;
  // the reference is not exact
  RC_ASSERT(square <= 1.02 * estimate.e * estimate.e);
}

/// e^2 is what its parts say, as are the local values.
RC_GTEST_PROP(Springs, are_a_part_of_the_error, (Random random)) {
  const SprungBlock block = random_sprung_block(random, 6);
  const Problem problem = block.on(block.mesh);
  const Estimate<2> estimate =
      estimated(problem, solved(problem), block.springs_on(block.mesh));
  RC_ASSERT(estimate.admissible);
  RC_ASSERT(estimate.springs >= 0);
  const double square =
      estimate.elastic * estimate.elastic + estimate.contact + estimate.springs;
  RC_ASSERT(std::abs(square - estimate.e * estimate.e) <= 1e-12 * square);
  RC_ASSERT(std::abs(estimate.local.norm() - estimate.relative) <=
            1e-9 * estimate.relative);
  // every sweep lowers it, by what is left at its end
  for (std::size_t k = 1; k < estimate.history.size(); ++k)
    RC_ASSERT(estimate.history[k] <= estimate.history[k - 1]);
  const Estimate<2> before = estimated(problem, solved(problem),
                                       block.springs_on(block.mesh), sweeps(0));
  RC_ASSERT(std::abs(before.e - estimate.history.front()) <= 1e-7 * before.e);
}

/// Where springs are stiff the body is held, and their tractions are as free as those of
/// a support.
TEST(Springs, that_are_stiff_are_judged_as_supports) {
  Random random(9);
  const Mesh mesh = irregular(6, 4, 6, 4, random);
  const auto pressed = [&](double k) {
    Problem problem = body(mesh, soft);
    add_traction(problem, left, {1, -0.5});
    BoundarySprings<2> springs;
    if (k > 0) {
      put_springs(
          mesh, top,
          [&](const Vector2d&, const Vector2d&) {
            return Spring{k * Matrix2d::Identity(), {0.001, -0.002}};
          },
          springs);
      assemble(springs, problem);
    } else {
      clamp(problem, top,
            [](const Vector2d&) { return Vector2d(0.001, -0.002); });
    }
    return estimated(problem, solved(problem), springs, sweeps(20));
  };
  const Estimate<2> clamped = pressed(0), sprung = pressed(1e8);
  EXPECT_NEAR(sprung.e, clamped.e, 1e-3 * clamped.e);
  EXPECT_NEAR(sprung.relative, clamped.relative, 1e-3 * clamped.relative);
}

/// What a support prescribes on their edge is none of theirs, and those inclined to it
/// are judged as they are.
TEST(Springs, share_an_edge_with_a_support) {
  Random random(12);
  const Mesh mesh = irregular(6, 4, 6, 4, random);
  const auto judged = [&](const Matrix2d& K) {
    Problem problem = body(mesh, soft);
    add_traction(problem, top, {-1, -2});
    BoundarySprings<2> springs;
    put_springs(
        mesh, right,
        [&](const Vector2d&, const Vector2d&) {
          return Spring{K, Vector2d(0, 0)};
        },
        springs);
    assemble(springs, problem);
    prescribe(problem, right, 0);
    return estimated(problem, solved(problem), springs);
  };
  const Estimate<2> both = judged(Vector2d(300, 40).asDiagonal()),
                    one = judged(Vector2d(0, 40).asDiagonal());
  EXPECT_TRUE(both.admissible && one.admissible);
  EXPECT_NEAR(both.e, one.e, 1e-9 * one.e);
  Matrix2d inclined;
  inclined << 300, 50, 50, 40;
  const Estimate<2> fixed = judged(inclined);
  EXPECT_TRUE(fixed.admissible) << fixed.reason;
  EXPECT_NEAR(fixed.e, one.e, 0.05 * one.e);  // nearly the same problem
}

/// Springs along a normal that is no axis, and units.
RC_GTEST_PROP(Springs, know_no_direction_and_no_unit, (Random random)) {
  const Mesh mesh = irregular(4, 3, 6, 4, random);
  const double angle = *real(0, 6), units = std::pow(10.0, *real(-6, 6)),
               k = std::pow(10.0, *real(0, 4));
  const Vector2d on_left = random_vector(2, random) - Vector2d(0, 1);
  const auto judged = [&](double turn, double unit) {
    const Matrix2d R = Eigen::Rotation2Dd(turn).toRotationMatrix();
    Mesh turned = rotated(mesh, turn);
    turned.vertices *= unit;
    Problem problem = body(turned, soft);
    add_traction(problem, left, R * on_left);
    BoundarySprings<2> springs;
    put_springs(
        turned, top,
        [&](const Vector2d&, const Vector2d& n) {
          return Spring{along(n, k / unit), unit * (R * Vector2d(0, -0.01))};
        },
        springs);
    put_springs(
        turned, right,
        [&](const Vector2d&, const Vector2d& n) {
          return Spring{along(n, k / unit), Vector2d::Zero()};
        },
        springs);
    assemble(springs, problem);
    return estimated(problem, solved(problem), springs);
  };
  const Estimate<2> as_is = judged(0, 1), other = judged(angle, units);
  RC_ASSERT(as_is.admissible && other.admissible);
  RC_ASSERT(std::abs(other.relative - as_is.relative) <= 1e-6 * as_is.relative);
}

TEST(Springs, of_another_stiffness_are_refused_by_name) {
  Problem problem = body(rectangle(4, 3, 6, 4), soft);
  add_traction(problem, left, {1, -1});
  const auto springs_of = [&](double k) {
    BoundarySprings<2> springs;
    put_springs(
        problem.mesh, top,
        [&](const Vector2d&, const Vector2d&) {
          return Spring{k * Matrix2d::Identity(), Vector2d::Zero()};
        },
        springs);
    return springs;
  };
  assemble(springs_of(30), problem);
  const ContactSolution<2> solution = solved(problem);
  EXPECT_TRUE(estimated(problem, solution, springs_of(30)).admissible);
  EXPECT_TRUE(
      says(refusal([&] { estimated(problem, solution, springs_of(31)); }),
           "spring= is not that of A: at vertex"));
  EXPECT_TRUE(
      says(refusal([&] { estimated(problem, solution); }), "give spring="));
  EXPECT_TRUE(
      says(refusal([&] { estimated(problem, solution, springs_of(-30)); }),
           "must not be negative"));
  BoundarySprings<2> in_contact = springs_of(30);
  put_springs(
      problem.mesh, bottom,
      [](const Vector2d&, const Vector2d&) {
        return Spring{Matrix2d::Identity(), Vector2d::Zero()};
      },
      in_contact);
  EXPECT_TRUE(says(refusal([&] { estimated(problem, solution, in_contact); }),
                   "springs are on the contact line"));
  BoundarySprings<2> changing = springs_of(30);
  changing.stiffness.col(0).setZero();
  for (Index b = 0; b < problem.mesh.boundary.cols(); ++b)
    if (problem.mesh.boundary_label[b] == top) changing.stiffness(0, b) = 0;
  EXPECT_TRUE(says(refusal([&] { estimated(problem, solution, changing); }),
                   "must be zero or positive all the way"));
}

}  // namespace
}  // namespace ffcontact
