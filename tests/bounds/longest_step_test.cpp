// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/longest_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "support/problems.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// l of a traction on the left side, on free dofs.
VectorXd pull_on_the_left(Problem problem) {
  problem.b.setZero();
  add_traction(problem, left, {1, 2});
  return on_free_dofs(problem.system(), problem.b);
}

/// l' K^-1 l with the dofs of the supports and of the contact line held.
double energy_of_held(const Problem& problem, const VectorXd& l) {
  const ElasticSystem system = problem.system();
  Flags held = system.prescribed;
  for (const int v : problem.line.vertex) held[2 * v] = held[2 * v + 1] = 1;
  std::vector<int> free;
  for (Index dof = 0; dof < l.size(); ++dof)
    if (!held[dof]) free.push_back(static_cast<int>(dof));
  const MatrixXd K = MatrixXd(system.stiffness)(free, free);
  const VectorXd pull = l(free);
  return pull.dot(K.ldlt().solve(pull));
}

TEST(LongestStep, is_that_of_twice_the_stress_where_contact_is_held) {
  const Problem problem = example_1(Multiplier::force, 4);
  const ElasticSystem system = problem.system();
  const CondensedStiffness stiffness(system,
                                     contact_dofs(problem.line, system));
  const VectorXd l = pull_on_the_left(problem);
  const double energy = energy_of_held(problem, l), stress = 3;
  EXPECT_NEAR(longest_step(system, &stiffness, l, stress),
              2 * stress / std::sqrt(energy), 1e-10);
}

TEST(LongestStep, is_six_times_that_of_hat_functions_without_a_factor) {
  const Problem problem = example_1(Multiplier::force, 4);
  const ElasticSystem system = problem.system();
  const VectorXd l = pull_on_the_left(problem);
  double energy = 0;
  for (Index dof = 0; dof < l.size(); ++dof)
    if (l[dof] != 0)
      energy += l[dof] * l[dof] / system.stiffness.coeff(dof, dof);
  EXPECT_NEAR(longest_step(system, nullptr, l, 3), 18 / std::sqrt(energy),
              1e-10);
}

}  // namespace
}  // namespace ffcontact
