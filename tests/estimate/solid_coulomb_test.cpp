// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/solid_coulomb.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>

#include "ffcontact/elastic/stiffness.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/nested_solids.hpp"
#include "support/random.hpp"
#include "support/solid_coulomb.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact::test {
namespace {

/// The bricks of a mesh and of one that is nested in it.
struct Nested {
  Vector3i cells;
  int ratio;
};

/// A solution with what is said of it.
struct JudgedSolid {
  ContactSolution<3> solution;
  Estimate<3> estimate;
  SolidCoulomb coulomb, held;

  explicit JudgedSolid(const SolidProblem& problem)
      : solution(problem.solve()),
        estimate(test::estimate(problem, solution)),
        coulomb(coulomb_of(problem, solution, estimate)),
        held(coulomb_of(problem, solution, estimate, StuckNodes::stick)) {}
};

/// r_hat of a coarse face at a point of it.
Vector3d traction_at(const SolidProblem& coarse, const Estimate<3>& estimate,
                     const Vector3d& x, const Vector3d& inside) {
  for (int m = 0; m < coarse.surface.face_count(); ++m) {
    const Matrix3d corners = coarse.mesh.vertices(
        Eigen::all, coarse.surface.vertex(coarse.surface.face_node.col(m)));
    // z = 0: barycentric coordinates in the plane
    Matrix3d A = corners;
    A.row(2).setOnes();
    const auto coordinates = [&](const Vector3d& at) {
      return Vector3d(A.inverse() * Vector3d(at.x(), at.y(), 1));
    };
    if (coordinates(inside).minCoeff() < 0) continue;
    return coarse.surface.frame(coarse.surface.face_node(0, m)) *
           estimate.face_tractions.col(m).reshaped(3, 3) * coordinates(x);
  }
  return Vector3d::Constant(infinity);
}

/// int over the contact surface of r_hat . field
double work_on_finer_mesh(const SolidProblem& coarse,
                          const Estimate<3>& estimate, const SolidProblem& fine,
                          const VectorXd& field) {
  double work = 0;
  for (int f : fine.surface.face) {
    const Matrix3d x =
        fine.mesh.vertices(Eigen::all, fine.faces.vertices.col(f));
    Matrix3d r;
    for (int k = 0; k < 3; ++k)
      r.col(k) = traction_at(coarse, estimate, x.col(k), x.rowwise().mean());
    const Matrix3d moments =
        facet_moments_of<3>(r, facet_measure(fine.mesh, fine.faces, f));
    for (int k = 0; k < 3; ++k)
      work +=
          moments.col(k).dot(field.segment<3>(3 * fine.faces.vertices(k, f)));
  }
  return work;
}

/// (|sigma_ref - sigma_hat|^2 + |u_ref - u_hat|^2)^(1/2): with d = u_ref - u_hat
///     |sigma_ref - sigma_hat|^2 = |sigma_hat - C eps(u_hat)|^2 + |d|^2 - 2 int (sigma_hat - C eps(u_hat)) : eps(d).
double true_error(const SolidProblem& coarse, const Estimate<3>& estimate,
                  const SolidProblem& fine, const Nested& nested) {
  const VectorXd u_hat = on_finer_brick(estimate.displacement, nested.cells,
                                        nested.ratio),
                 d = fine.solve().displacement - u_hat;
  const RowMatrix K = stiffness(fine.mesh, solved_solid(fine, {}).hooke);
  const std::vector<char> prescribed = fine.system().prescribed;
  double work = work_on_finer_mesh(coarse, estimate, fine, d);
  for (Index dof = 0; dof < d.size(); ++dof)
    if (!prescribed[dof]) work += fine.b[dof] * d[dof];
  const double square = d.dot(K * d), cross = work - u_hat.dot(K * d),
               stress =
                   estimate.elastic * estimate.elastic + square - 2 * cross;
  return std::sqrt(square + stress);
}

SolidMesh block_of(const Vector3i& cells) { return brick(cells, {80, 40, 40}); }

TEST(SolidCoulomb, bounds_the_error_of_blocks) {
  const Nested nested{{4, 2, 2}, 4};
  for (BlockCase loads : {BlockCase::press, BlockCase::press_x,
                          BlockCase::shear, BlockCase::lift})
    for (double mu : {0.2, 0.5}) {
      const SolidProblem coarse =
                             block_problem(block_of(nested.cells), loads, mu),
                         fine = block_problem(
                             block_of(nested.ratio * nested.cells), loads, mu);
      const JudgedSolid judged(coarse);
      const double error = true_error(coarse, judged.estimate, fine, nested);
      std::printf(
          "case %d, mu %.1f: error %.3f, e %.3f, kappa %.3f, missed %.4f, B "
          "%.3f; held %.3f, %.4f, %.3f\n",
          static_cast<int>(loads), mu, error, judged.estimate.e,
          judged.coulomb.kappa, judged.coulomb.missed, judged.coulomb.bound,
          judged.held.kappa, judged.held.missed, judged.held.bound);
      EXPECT_GE(judged.coulomb.bound, error);
      EXPECT_GE(judged.held.bound, error);
      EXPECT_LT(judged.coulomb.bound, 5 * error);
      EXPECT_LE(judged.held.kappa, (1 + 1e-9) * judged.coulomb.kappa);
      EXPECT_LT(judged.coulomb.missed, 0.1 * judged.estimate.e);
    }
}

TEST(SolidCoulomb, is_lower_where_sticking_nodes_are_held) {
  const JudgedSolid judged(
      block_problem(block_of({4, 2, 2}), BlockCase::shear, 0.5));
  EXPECT_LT(judged.held.kappa, 0.6 * judged.coulomb.kappa);
  EXPECT_LT(judged.held.missed, 0.6 * judged.coulomb.missed);
}

/// A body of 3 x 2 x 2 pressed from above and drawn aside at random.
struct AnyLoads {
  double mu;
  bool is_clamped;
  VectorXd load;

  explicit AnyLoads(Random& random)
      : mu(*real(0.05, 1)),
        is_clamped(random() % 2),
        load(random_vector(6, random)) {}
  SolidProblem on(const Vector3i& cells) const {
    SolidProblem problem(brick(cells, {3, 2, 2}), mu);
    problem.load(high_x, 100 * load.head<3>());
    if (is_clamped) {
      problem.load(high_z, {50 * load[3], 50 * load[4], -200 + 50 * load[5]});
      problem.move(low_x, [](const Vector3d&) { return Vector3d::Zero(); });
    } else {
      problem.move(high_z, [&](const Vector3d& x) {
        return Vector3d(0.02 * load[3] + 0.005 * x.y(), 0.02 * load[4],
                        -0.03 + 0.005 * load[5] * x.x());
      });
    }
    return problem;
  }
};

RC_GTEST_PROP(SolidCoulomb, bounds_the_error_under_random_loads,
              (Random random)) {
  const AnyLoads loads(random);
  const Nested nested{{3, 2, 2}, 2};
  const SolidProblem coarse = loads.on(nested.cells),
                     fine = loads.on(nested.ratio * nested.cells);
  const JudgedSolid judged(coarse);
  RC_PRE(judged.solution.status == ContactStatus::converged);
  RC_ASSERT(judged.estimate.reason == "");
  const double error = true_error(coarse, judged.estimate, fine, nested),
               bound = judged.coulomb.bound;
  RC_CLASSIFY(std::isfinite(bound), "bound");
  RC_CLASSIFY(error > (1 + 1e-6) * judged.estimate.e, "e alone is none");
  RC_ASSERT(bound >= error);
}

template <class Visit>
void for_corners(const SolidProblem& problem, const Estimate<3>& found,
                 const Visit& visit) {
  const ContactSurface& surface = problem.surface;
  for (int m = 0; m < surface.face_count(); ++m)
    for (int k = 0; k < 3; ++k)
      visit(m, surface.face_node(k, m),
            Vector3d(found.face_tractions.col(m).segment<3>(3 * k)),
            facet_measure(problem.mesh, problem.faces, surface.face[m]));
}

/// int phi_i (r_t + mu |r_n| s) on a plane.
Matrix2Xd missed_moments(const SolidProblem& problem, const Estimate<3>& found,
                         const Matrix2Xd& s) {
  const double mu = problem.law.friction[0];
  Matrix2Xd moments = Matrix2Xd::Zero(2, s.cols());
  for_corners(problem, found,
              [&](int m, int node, const Vector3d& r, double area) {
                const Vector2d d = r.tail<2>() - mu * r[0] * s.col(node);
                for (int other : problem.surface.face_node.col(m))
                  moments.col(other) += area / (other == node ? 6 : 12) * d;
              });
  return moments;
}

/// On a plane: s, d and their moments as the header says, from the arrays alone.
RC_GTEST_PROP(SolidCoulomb, directions_and_moments_are_those_of_the_pair,
              (Random random)) {
  const SolidProblem problem = AnyLoads(random).on({3, 2, 2});
  const ContactSolution<3> solution = problem.solve();
  RC_PRE(solution.status == ContactStatus::converged);
  const Estimate<3> found = estimate(problem, solution);
  const DirectedSlip slip =
      directed_slip(topology_of(problem.mesh), problem.surface,
                    solved_solid(problem, solution), found);
  const ContactSurface& surface = problem.surface;
  const double mu = problem.law.friction[0];
  const Matrix3Xd w = contact_components(surface, found.displacement);
  const int nodes = surface.node_count();
  Matrix2Xd force = Matrix2Xd::Zero(2, nodes), s(2, nodes);
  VectorXd bound = VectorXd::Zero(nodes);
  for_corners(problem, found,
              [&](int, int node, const Vector3d& r, double area) {
                force.col(node) += area * r.tail<2>();
                bound[node] -= area * mu * r[0];
              });
  for (int i = 0; i < nodes; ++i) {
    const Vector2d slipped = w.col(i).tail<2>();
    if (slipped.norm() > 1e-9 * found.displacement.lpNorm<Eigen::Infinity>())
      s.col(i) = slipped / slipped.norm();
    else
      s.col(i) =
          bound[i] > 0 ? Vector2d(-force.col(i) / bound[i]) : Vector2d(0, 0);
    RC_ASSERT((slip.weight.col(i) - s.col(i)).norm() < 1e-9);
    RC_ASSERT(slip.weight.col(i).norm() < 1 + 1e-12);
  }
  const Matrix2Xd moments = missed_moments(problem, found, s);
  RC_ASSERT((slip.missed - moments).norm() <
            1e-9 * (force.norm() + moments.norm()));
}

/// Relaxed as those of one body are.
RC_GTEST_PROP(SolidCoulomb, moments_between_bodies_that_match_are_of_their_pair,
              (Random random)) {
  SolidMesh lower = brick({3, 2, 1}, {3, 2, 1});
  lower.vertices.row(2).array() -= 1;
  SolidStack two({brick({3, 2, 2}, {3, 2, 1}), lower}, *real(0.05, 0.5));
  two.problem.load(two.label(0, high_x), 10 * random_vector(3, random));
  two.problem.move(two.label(0, high_z), [](const Vector3d& x) {
    return Vector3d(2e-3, 1e-3, -3e-3 + 5e-4 * x.x());
  });
  two.problem.move(two.label(1, low_z),
                   [](const Vector3d&) { return Vector3d::Zero(); });
  const ContactSolution<3> solution = two.problem.solve();
  RC_PRE(solution.status == ContactStatus::converged);
  const Estimate<3> found = estimate(two.problem, solution);
  const DirectedSlip slip =
      directed_slip(topology_of(two.problem.mesh), two.problem.surface,
                    solved_solid(two.problem, solution), found);
  const Matrix2Xd moments = missed_moments(two.problem, found, slip.weight);
  RC_ASSERT(moments.norm() > 0);
  RC_ASSERT((slip.missed - moments).norm() < 1e-9 * moments.norm());
}

RC_GTEST_PROP(SolidCoulomb, homogeneous_slip_misses_nothing, (Random random)) {
  // as homogeneous_slip_has_no_error, along x
  const double lambda = 13e3 * 0.2 / 0.72, G = 13e3 / 2.4, mu = 0.3, eps = 1e-3,
               g = mu * (lambda + 2 * G) * eps / G;
  SolidProblem problem(irregular_solid(random), mu);
  const Vector3d on_x(lambda * eps, 0, G * g), on_y(0, lambda * eps, 0);
  problem.load(low_x, on_x);
  problem.load(high_x, -on_x);
  problem.load(low_y, on_y);
  problem.load(high_y, -on_y);
  problem.move(high_z, [&](const Vector3d& x) {
    return Vector3d(-0.05 - g * x.z(), 0, -eps * x.z());
  });
  const JudgedSolid judged(problem);
  const double size = judged.estimate.elastic / judged.estimate.relative *
                      judged.estimate.e / judged.estimate.elastic;
  RC_ASSERT(judged.coulomb.missed < 1e-9 * size);
  RC_ASSERT(judged.coulomb.kappa > 1);
  RC_ASSERT(judged.coulomb.bound < 1e-5 * size);
}

TEST(SolidCoulomb, is_e_without_friction_that_depends_on_pressure) {
  const SolidProblem smooth =
      block_problem(block_of({4, 2, 2}), BlockCase::shear, 0);
  const JudgedSolid judged(smooth);
  EXPECT_EQ(judged.coulomb.kappa, 0);
  EXPECT_EQ(judged.coulomb.missed, 0);
  EXPECT_EQ(judged.coulomb.bound, judged.estimate.e);

  SolidProblem trescas =
      block_problem(block_of({4, 2, 2}), BlockCase::shear, 1);
  const int nodes = trescas.surface.node_count();
  trescas.law.slip_bound = VectorXd::Constant(nodes, 2);
  const JudgedSolid of_trescas(trescas);
  EXPECT_EQ(of_trescas.coulomb.kappa, 0);
  EXPECT_EQ(of_trescas.coulomb.bound, of_trescas.estimate.e);
}

TEST(SolidCoulomb, is_infinite_at_the_shear_limit_and_where_not_admissible) {
  SolidProblem limited =
      block_problem(block_of({4, 2, 2}), BlockCase::shear, 0.3);
  const int nodes = limited.surface.node_count();
  limited.law.shear_limit = VectorXd::Constant(nodes, 1);
  EXPECT_TRUE(std::isinf(JudgedSolid(limited).coulomb.kappa));
  limited.law.shear_limit = VectorXd::Constant(nodes, 1e3);
  EXPECT_TRUE(std::isfinite(JudgedSolid(limited).coulomb.bound));

  const ContactSolution<3> solution = limited.solve();
  Estimate<3> found = estimate(limited, solution);
  found.admissible = false;
  EXPECT_TRUE(std::isinf(coulomb_of(limited, solution, found).bound));
}

/// The coefficient varies: kappa is in units of the largest one.
TEST(SolidCoulomb, weighs_a_coefficient_that_varies) {
  SolidProblem problem =
      block_problem(block_of({4, 2, 2}), BlockCase::lift, 0.2);
  for (int i = 0; i < problem.surface.node_count(); ++i)
    problem.law.friction[i] =
        0.2 + 0.004 * problem.mesh.vertices(0, problem.surface.vertex[i]);
  const ContactSolution<3> solution = problem.solve();
  const Estimate<3> found = estimate(problem, solution);
  const DirectedSlip slip =
      directed_slip(topology_of(problem.mesh), problem.surface,
                    solved_solid(problem, solution), found);
  const VectorXd size = slip.weight.colwise().norm(),
                 expected = problem.law.friction / 0.52;
  EXPECT_LT((size - expected).cwiseMax(0).norm(), 1e-12);
  EXPECT_NEAR(size.maxCoeff(), 1, 1e-12);
  EXPECT_EQ(coulomb_of(problem, solution, found).friction,
            problem.law.friction.maxCoeff());
}

}  // namespace
}  // namespace ffcontact::test
