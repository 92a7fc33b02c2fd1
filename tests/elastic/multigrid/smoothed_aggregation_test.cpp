// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/smoothed_aggregation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "ffcontact/elastic/multigrid/body_grid.hpp"
#include "ffcontact/linear/iterative/conjugate_gradients.hpp"
#include "support/solid_problems.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A block 2 x 1 x 1 with its vertices moved, some components held on low_z.
SolidProblem block(int n, const std::vector<int>& held_along_axes) {
  std::mt19937 random(1);
  SolidProblem problem(
      moved(brick({2 * n, n, n}, {2, 1, 1}), 1.0 / n, 0.15, random));
  for (int c = 0; c < 3; ++c)
    if (held_along_axes[c]) problem.guide(low_z, c);
  return problem;
}

SmoothedAggregation<3> multigrid(const SolidProblem& problem,
                                 const ElasticSystem& system) {
  return SmoothedAggregation<3>(
      body_grid<3>(system, problem.mesh.vertices, VertexFrames<3>(system)));
}

/// Steps of conjugate gradients to 1e-10 for K held where `held` says so, too.
int steps(const ElasticSystem& system, const SmoothedAggregation<3>& M,
          const VectorXd& load, const Flags& held) {
  int count = 0;
  const auto u = conjugate_gradients(
      [&](const VectorXd& u) {
        return without<VectorXd>(held,
                                 on_free_dofs(system, system.stiffness * u));
      },
      [&](const VectorXd& r) -> VectorXd {
        ++count;
        const double size = r.cwiseAbs().maxCoeff();
        return size * M((r / size).cast<float>()).cast<double>();
      },
      without<VectorXd>(held, on_free_dofs(system, load)), {1e-10, 100});
  EXPECT_TRUE(u.has_value());
  return count;
}

/// Of every frequency, the same on any machine.
VectorXd mixed_load(Index dofs) {
  return VectorXd::NullaryExpr(dofs, [](Index k) {
    return static_cast<double>((k * 7919) % 1009) / 1009 - 0.5;
  });
}

TEST(SmoothedAggregation, takes_as_many_steps_on_finer_meshes) {
  for (const std::vector<int>& held :
       std::vector<std::vector<int>>{{1, 1, 1}, {0, 0, 1}}) {
    std::vector<int> counts;
    for (const int n : {5, 10, 20}) {
      const SolidProblem problem = block(n, held);
      const ElasticSystem system = problem.system();
      const Flags none(system.dof_count(), 0);
      // does no work on the sliding motions that are left where only z is held
      const VectorXd load =
          system.stiffness *
          on_free_dofs(system, mixed_load(system.dof_count()));
      counts.push_back(steps(system, multigrid(problem, system), load, none));
    }
    EXPECT_LE(counts.back(), 26);
    EXPECT_LE(counts.back(), counts.front() + 10);
  }
}

/// Vertices on low_z held along z, and let go again.
TEST(SmoothedAggregation, follows_what_is_held) {
  SolidProblem problem = block(12, {0, 0, 0});
  problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  const ElasticSystem system = problem.system();
  SmoothedAggregation<3> M = multigrid(problem, system);
  const VectorXf right =
      on_free_dofs(system, mixed_load(system.dof_count())).cast<float>();
  const VectorXf before = M(right);
  const VertexFrames<3> frames(system);
  std::vector<SmoothedAggregation<3>::Change> hold, release;
  Flags held(system.dof_count(), 0);
  for (int v : vertices_on(problem.mesh, low_z)) {
    const auto diagonal = M.matrix().block(v, v);
    const auto motions = motions_along<3>(frames.of(v));
    release.push_back({v, diagonal, motions});
    auto& change = hold.emplace_back(release.back());
    change.diagonal.row(2).setZero();
    change.diagonal.col(2).setZero();
    change.motions.row(2).setZero();
    held[3 * v + 2] = 1;
  }
  M.put(hold);
  const VectorXf u = M(without(held, right));
  for (std::size_t dof = 0; dof < held.size(); ++dof)
    if (held[dof] || system.prescribed[dof]) {
      EXPECT_EQ(u[dof], 0);
    }
  EXPECT_LE(steps(system, M, mixed_load(system.dof_count()), held), 26);
  M.put(release);
  EXPECT_EQ(M(right), before);
}

/// What follows a few vertices has the digits of what is made of all of them anew.
TEST(SmoothedAggregation, follows_as_if_all_had_changed) {
  const SolidProblem problem = block(12, {1, 1, 1});
  const ElasticSystem system = problem.system();
  SmoothedAggregation<3> M = multigrid(problem, system);
  const VertexFrames<3> frames(system);
  std::vector<SmoothedAggregation<3>::Change> few, all;
  const int half = problem.mesh.vertex_count() / 2;
  for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
    all.push_back({v, M.matrix().block(v, v), motions_along<3>(frames.of(v))});
    if (v < half || v > half + 2) continue;
    all.back().diagonal.row(0).setZero();
    all.back().diagonal.col(0).setZero();
    all.back().motions.row(0).setZero();
    few.push_back(all.back());
  }
  const VectorXf right =
      on_free_dofs(system, mixed_load(system.dof_count())).cast<float>();
  M.put(few);
  const VectorXf after_few = M(right);
  M.put(all);
  EXPECT_EQ(after_few, M(right));
}

TEST(SmoothedAggregation, is_symmetric) {
  const SolidProblem problem = block(8, {1, 1, 1});
  const ElasticSystem system = problem.system();
  const SmoothedAggregation<3> M = multigrid(problem, system);
  const VectorXf a = on_free_dofs(system, mixed_load(system.dof_count()))
                         .cast<float>(),
                 b = a.reverse();
  const VectorXf free_b = on_free_dofs(system, b.cast<double>()).cast<float>();
  const double one = M(a).cast<double>().dot(free_b.cast<double>()),
               other = M(free_b).cast<double>().dot(a.cast<double>());
  EXPECT_NEAR(one, other, 1e-5 * std::abs(one));
  EXPECT_GT(M(a).cast<double>().dot(a.cast<double>()), 0);
}

TEST(SmoothedAggregation, has_the_same_digits_on_two_threads) {
  const SolidProblem problem = block(10, {1, 1, 1});
  const ElasticSystem system = problem.system();
  const VectorXf right =
      on_free_dofs(system, mixed_load(system.dof_count())).cast<float>();
  const auto answer = [&] { return multigrid(problem, system)(right); };
  EXPECT_EQ(on_threads(1, answer), on_threads(2, answer));
}

}  // namespace
}  // namespace ffcontact
