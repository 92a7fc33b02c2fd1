// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of a solid, all of solve_contact on an ElasticSystem, and the estimate of its
// error with the default steps, beside one linear solve of the same matrix: a block
// 80 x 40 x 40 of 8 n x 4 n x 4 n bricks on a rigid plane, friction 0.5, its top held,
// pressed from two sides (all nodes slip) or from one (some lift off).
#include "comparison.hpp"
#include "linear_solve.hpp"
#include "support/solid_estimates.hpp"

namespace ffcontact::bench {

struct SolidCase {
  test::SolidProblem problem;
  ElasticSystem system;
};

SolidCase solid_case(int n, test::BlockCase loads) {
  test::SolidProblem problem = test::block_problem(
      test::brick({8 * n, 4 * n, 4 * n}, {80, 40, 40}), loads, 0.5);
  ElasticSystem system = problem.system();
  return {std::move(problem), std::move(system)};
}

/// Made once, the last one only: a large one takes more memory than its solution.
std::shared_ptr<const SolidCase> case_of(int n, test::BlockCase loads) {
  static std::shared_ptr<const SolidCase> last;
  static std::pair<int, test::BlockCase> key;
  if (!last || key != std::make_pair(n, loads)) {
    last = std::make_shared<const SolidCase>(solid_case(n, loads));
    key = {n, loads};
  }
  return last;
}

std::function<void()> linear_solve(int n) {
  const auto body = case_of(n, test::BlockCase::press);
  const auto solve = std::make_shared<LinearSolve>(body->system);
  return [solve] { solve->run(); };
}

Case contact(test::BlockCase loads) {
  return [loads](int n) {
    const auto body = case_of(n, loads);
    return [body] {
      const ContactSettings settings;
      const test::SolidProblem& p = body->problem;
      if (!solve_contact(p.mesh, p.surface, p.law, body->system, settings)
               .accepted(settings))
        throw std::runtime_error("the contact problem is not solved");
    };
  };
}

/// The contact problem is solved beforehand, which does not count.
Case estimate(test::BlockCase loads) {
  return [loads](int n) {
    const auto body = case_of(n, loads);
    const test::SolidProblem& problem = body->problem;
    const auto topology =
        std::make_shared<const Topology<3>>(topology_of(problem.mesh));
    const auto solved = std::make_shared<const SolvedBody<3>>(
        test::solved_solid(problem, solve_contact(problem.mesh, problem.surface,
                                                  problem.law, body->system)));
    return [body, topology, solved] {
      const Estimate<3> result = estimate_error(
          *topology, body->problem.surface, body->system, *solved);
      if (!result.admissible) throw std::runtime_error(result.reason);
    };
  };
}

int solid_dofs(int n) { return 3 * (8 * n + 1) * (4 * n + 1) * (4 * n + 1); }

}  // namespace ffcontact::bench

int main(int argc, char** argv) {
  using namespace ffcontact::bench;
  using ffcontact::test::BlockCase;
  return compare(argc, argv,
                 {{"solid, linear solve", linear_solve},
                  {"solid, pressed", contact(BlockCase::press)},
                  {"solid, lifted", contact(BlockCase::press_x)},
                  {"solid, estimate", estimate(BlockCase::press)}},
                 {4, 5, 7, 8, 11}, solid_dofs);
}
