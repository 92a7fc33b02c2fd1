// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_problems.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactSettings settings_of(SchurStorage storage, Precision precision) {
  ContactSettings settings;
  settings.storage = storage;
  if (precision == Precision::single) settings.single_precision_from = 0;
  return settings;
}

struct Answers {
  SurfaceSolution whole, found;

  Answers(const SolidProblem& problem, Precision precision)
      : whole(problem.solve(settings_of(SchurStorage::whole, precision))) {
    if (!whole.accepted({})) RC_DISCARD();
    found = problem.solve(settings_of(SchurStorage::distributed, precision));
    RC_ASSERT(found.accepted({}));
    RC_ASSERT(found.stiffness->storage() == SchurStorage::distributed);
  }

  /// Of one solution: where there are several, each way may end at its own.
  void require_same_displacement() const {
    RC_ASSERT((found.displacement - whole.displacement).norm() <=
              1e-9 * whole.displacement.norm());
  }
};

/// By products alone and by dense algebra: the same states and digits.
void same_answers(const SolidProblem& problem, Precision precision) {
  const Answers answers(problem, precision);
  const auto& [whole, found] = answers;
  answers.require_same_displacement();
  RC_ASSERT(found.state == whole.state);
  RC_ASSERT((found.force - whole.force).norm() <= 1e-9 * whole.force.norm());
}

Precision any_precision() {
  return *rc::gen::element(Precision::full, Precision::single);
}

/// Coulomb's law, Tresca's or none.
SurfaceLaw any_friction(SurfaceLaw law) {
  const int kind = *rc::gen::inRange(0, 3);
  const double mu = *real(0, 1);
  law.friction.setConstant(kind == 0 ? 0 : mu);
  if (kind == 2) law.slip_bound = VectorXd::Constant(law.friction.size(), mu);
  return law;
}

RC_GTEST_PROP(DistributedSchur, answers_as_dense_algebra_of_blocks,
              (Random random)) {
  SolidProblem problem =
      block_problem(moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random),
                    static_cast<BlockCase>(random() % 4), 0);
  problem.law = any_friction(problem.law);
  problem.law.gap =
      0.01 * random_vector(problem.surface.node_count(), random).cwiseAbs();
  same_answers(problem, any_precision());
}

RC_GTEST_PROP(DistributedSchur, answers_as_dense_algebra_of_stacks,
              (Random random)) {
  SolidProblem problem = random_solids(0, random).problem;
  problem.law = any_friction(problem.law);
  same_answers(problem, any_precision());
}

/// With Tresca's law, where Newton cycles from all states tried.
struct Cycling {
  unsigned seed;
  double slip_bound;
};

SolidProblem cycling_problem(const Cycling& cycling) {
  Random random(cycling.seed);
  SolidProblem problem = random_solids(0, random).problem;
  problem.law.slip_bound =
      VectorXd::Constant(problem.surface.node_count(), cycling.slip_bound);
  return problem;
}

class CyclingProblems : public testing::TestWithParam<Cycling> {};
INSTANTIATE_TEST_SUITE_P(Found, CyclingProblems,
                         testing::Values(Cycling{11462, 0.969},
                                         Cycling{18133, 0.648},
                                         Cycling{19855, 0.908},
                                         Cycling{857052078, 0.735}));

TEST_P(CyclingProblems, are_answered_by_products) {
  const SolidProblem problem = cycling_problem(GetParam());
  const SurfaceSolution whole = problem.solve();
  for (Precision precision : {Precision::full, Precision::single}) {
    const SurfaceSolution found =
        problem.solve(settings_of(SchurStorage::distributed, precision));
    EXPECT_TRUE(found.accepted({}));
    EXPECT_LT((found.displacement - whole.displacement).norm(),
              1e-9 * whole.displacement.norm());
  }
}

TEST_P(CyclingProblems, keep_to_the_systems_that_they_are_given) {
  const SolidProblem problem = cycling_problem(GetParam());
  for (int most : {130, 165, 171}) {
    ContactSettings settings =
        settings_of(SchurStorage::distributed, Precision::full);
    settings.max_iterations = most;
    EXPECT_LE(problem.solve(settings).iterations, most);
  }
}

/// On an edge a vertex has a node of each sheet, whose rows depend on the first one's. What
/// each of them carries is not unique, and with Coulomb's law the answer is not either.
RC_GTEST_PROP(DistributedSchur, answers_as_dense_algebra_at_edges,
              (Random random)) {
  SolidProblem problem(moved(brick({3, 2, 2}, {3, 2, 2}), 1, 0.15, random), 0,
                       {low_z, low_x});
  problem.law = any_friction(problem.law);
  const Vector3d shift(*real(0, 1e-3), *real(-1e-3, 1e-3), *real(-2e-3, 0));
  problem.load(high_x, {*real(-20, 5), 0, 0});
  problem.move(high_z, [&](const Vector3d& x) {
    return Vector3d(shift + 1e-3 * Vector3d(0, 0, x.x() - 1.5));
  });
  const Answers answers(problem, any_precision());
  if (nodal_law(problem.law, problem.surface).is_convex())
    answers.require_same_displacement();
}

/// At random one of both may need doubles where the other one does not.
TEST(DistributedSchur, is_content_with_single_precision_as_dense_algebra_is) {
  const SolidProblem problem =
      block_problem(brick({4, 2, 2}, {80, 40, 40}), BlockCase::press, 0.3);
  for (SchurStorage storage : {SchurStorage::whole, SchurStorage::distributed})
    EXPECT_EQ(problem.solve(settings_of(storage, Precision::single))
                  .stiffness->precision(),
              Precision::single);
}

/// S is singular; no dof is prescribed but those of planes of symmetry, or none.
RC_GTEST_PROP(DistributedSchur, answers_as_dense_algebra_of_free_bodies,
              (Random random)) {
  SolidProblem problem(moved(brick({4, 3, 2}, {4, 3, 2}), 1, 0.15, random),
                       *real(0.2, 1));
  problem.load(high_z, {*real(-1, 1), *real(-1, 1), -10});
  if (random() % 2) problem.guide(low_x, 0);
  same_answers(problem, Precision::full);
}

}  // namespace
}  // namespace ffcontact
