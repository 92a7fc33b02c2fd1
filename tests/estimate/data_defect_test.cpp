// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/data_defect.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/nodal_pressures.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// What the estimate says when one thing about the data of example 1 is wrong.
template <class Spoil>
std::string sentence_about(Multiplier multiplier, Spoil spoil) {
  Problem problem = example_1(multiplier, 4);
  const ContactSolution solution = solved(problem);
  SolvedBody body = solved_body(problem, solution);
  spoil(problem, body, solution);
  return refusal([&] {
    estimate_error(topology_of(problem.mesh), problem.line, problem.system(),
                   body, EstimateSettings{});
  });
}

TEST(DataDefect, names_the_law_and_its_factor) {
  const std::string sentence =
      sentence_about(Multiplier::force,
                     [](Problem&, SolvedBody& body, const ContactSolution&) {
                       for (Matrix3d& C : body.hooke) C *= 2;
                     });
  EXPECT_TRUE(says(
      sentence, "lambda and G (or hooke) are not those of A: A is 0.5 times"))
      << sentence;
}

/// Displacements alone load the body, and nothing touches the foundation: equilibrium
/// does not see the factor.
TEST(DataDefect, names_the_law_where_equilibrium_cannot) {
  Problem problem = body(rectangle(6, 6, 1, 1), material(1000, 0.3), {left});
  clamp(problem, bottom);
  clamp(problem, top, [](const Vector2d& x) -> Vector2d {
    return {0.01 * (1 + x.x()), 0.01};
  });
  SolvedBody body = solved_body(problem, solved(problem));
  ASSERT_EQ(body.pressure.cwiseAbs().maxCoeff(), 0);
  for (Matrix3d& C : body.hooke) C *= 2;
  EXPECT_TRUE(says(refusal([&] {
                     estimate_error(topology_of(problem.mesh), problem.line,
                                    problem.system(), body, {});
                   }),
                   "A is 0.5 times the stiffness of the law"));
}

TEST(DataDefect, names_the_vertex_where_the_law_of_one_region_is_off) {
  const std::string sentence = sentence_about(
      Multiplier::force, [](Problem&, SolvedBody& body,
                            const ContactSolution&) { body.hooke[9] *= 3; });
  EXPECT_TRUE(says(
      sentence,
      "A is not the stiffness of lambda and G (or hooke): its row of vertex "))
      << sentence;
}

TEST(DataDefect, names_a_penalty_that_does_not_prescribe) {
  const std::string sentence =
      sentence_about(Multiplier::force,
                     [](Problem& problem, SolvedBody&, const ContactSolution&) {
                       problem.A.coeffRef(20, 20) += 1e10;
                     });
  EXPECT_TRUE(says(sentence, "A has 1e+10 more on its diagonal at vertex 10 "))
      << sentence;
}

TEST(DataDefect, names_a_point_support) {
  Problem problem = example_1(Multiplier::force, 2);
  prescribe_dof(problem, 2 * 5 + 1, 0.01);  // the middle of the loaded side
  const std::string sentence =
      refusal([&] { estimated(problem, solved(problem)); });
  EXPECT_TRUE(says(sentence, "vertex 5 (0, 20)") &&
              says(sentence, "it is the reaction of a point support"))
      << sentence;
}

TEST(DataDefect, names_the_multiplier_that_the_pressures_belong_to) {
  const std::string of_forces = sentence_about(
      Multiplier::force,
      [](Problem& problem, SolvedBody& body, const ContactSolution& solution) {
        body.pressure = lumped_pressures(problem.line, solution.force);
        body.law.multiplier = Multiplier::pressure;
      });
  EXPECT_TRUE(
      says(of_forces,
           "pn and pt fit u with multiplier=\"force\", not with \"pressure\""))
      << of_forces;
  const std::string of_pressures = sentence_about(
      Multiplier::pressure,
      [](Problem& problem, SolvedBody& body, const ContactSolution& solution) {
        body.law.multiplier = Multiplier::force;
        body.pressure =
            multiplier_density(problem.line, Multiplier::force,
                               prescribed_dofs(problem.A), solution.pressure);
      });
  EXPECT_TRUE(
      says(of_pressures,
           "pn and pt fit u with multiplier=\"pressure\", not with \"force\""))
      << of_pressures;
}

TEST(DataDefect, names_the_loads_that_are_not_those_of_u) {
  const std::string traction = sentence_about(
      Multiplier::force, [](Problem&, SolvedBody& body,
                            const ContactSolution&) { body.neumann *= 2; });
  EXPECT_TRUE(says(traction,
                   "on the boundary: give the traction=, initialstrain= and "
                   "initialstress= u was computed with"))
      << traction;
  const std::string inside =
      sentence_about(Multiplier::force,
                     [](Problem&, SolvedBody& body, const ContactSolution&) {
                       body.body_loads.array() += 1;
                     });
  EXPECT_TRUE(says(inside,
                   "inside the body: give the bodyforce=, initialstrain= and "
                   "initialstress= u was computed with"))
      << inside;
  const std::string contact = sentence_about(
      Multiplier::force, [](Problem&, SolvedBody& body,
                            const ContactSolution&) { body.pressure *= 1.1; });
  EXPECT_TRUE(
      says(contact, "on the contact line: give pn and pt of the solution u"))
      << contact;
}

}  // namespace
}  // namespace ffcontact
