// SPDX-License-Identifier: GPL-3.0-or-later
// Spoilt answers are found: one number of an answer without a find is changed, and the
// check named must see it.
#include <gtest/gtest.h>

#include <functional>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "generator.hpp"
#include "ground.hpp"
#include "trial.hpp"

namespace ffcontact::fuzz {
namespace {

struct Answer {
  Case problem;
  Assembled parts;
  ContactSolution<2> solution;
  Estimate<2> estimate;
};

Finds finds_of(const Answer& answer) {
  Finds all = line_finds(answer.problem, answer.parts);
  for (const Finds& more :
       {solution_finds(answer.problem, answer.parts, answer.solution),
        estimate_finds(answer.problem, answer.parts, answer.estimate)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

bool has(const Finds& finds, const std::string& check) {
  return std::any_of(finds.begin(), finds.end(),
                     [&](const Find& f) { return f.check == check; });
}

/// The node with the largest normal force among those that nothing else holds.
int pressed_node(const Answer& answer) {
  int best = 0;
  double force = 0;
  for (int i = 0; i < answer.parts.line.node_count(); ++i) {
    const int x = 2 * answer.parts.line.vertex[i];
    if (answer.parts.prescribed[x] || answer.parts.prescribed[x + 1] ||
        answer.solution.force(0, i) >= force)
      continue;
    force = answer.solution.force(0, i);
    best = i;
  }
  return best;
}

/// Is there something of everything: contact forces, stresses, an error?
bool is_full(const Answer& answer) {
  const int x = 2 * answer.parts.line.vertex[pressed_node(answer)];
  return answer.solution.force(0, pressed_node(answer)) < 0 &&
         !answer.parts.prescribed[x] && answer.estimate.relative > 1e-3 &&
         answer.estimate.relative < 0.5 && answer.parts.mesh().cell_count() > 8;
}

/// The first random problem that is as wanted and has an answer without a find.
Answer clean_answer(const std::function<bool(const Case&)>& wanted) {
  for (std::uint64_t index = 0; index < 5000; ++index) {
    Answer answer{random_case(2001, index), {}, {}, {}};
    if (answer.problem.promise != Promise::solution || !wanted(answer.problem))
      continue;
    const Outcome outcome = outcome_of(answer.problem);
    if (!outcome.finds.empty() || outcome.answer != "judged") continue;
    answer.parts = assembled(answer.problem);
    const ElasticSystem system = elastic_system(answer.parts.A, answer.parts.b);
    try {
      answer.solution = solve_contact(answer.parts.mesh(), answer.parts.line,
                                      answer.parts.law, system);
    } catch (const std::invalid_argument&) {
      continue;
    }
    answer.estimate =
        estimate_error(topology_of(answer.parts.mesh()), answer.parts.line,
                       system, answer.parts.solved(answer.solution));
    if (is_full(answer) && finds_of(answer).empty()) return answer;
  }
  throw std::runtime_error("no such problem");
}

std::vector<Answer> answers() {
  std::vector<Answer> result;
  for (Law law : {Law::frictionless, Law::tresca, Law::coulomb})
    for (Multiplier multiplier : {Multiplier::force, Multiplier::pressure})
      for (std::size_t bodies : {1, 2})
        result.push_back(clean_answer([=](const Case& c) {
          return c.law == law && c.multiplier == multiplier &&
                 c.bodies.size() == bodies && c.has_opposites() == (bodies > 1);
        }));
  return result;
}

const std::vector<Answer>& all_answers() {
  static const std::vector<Answer> all = answers();
  return all;
}

void expect_found(const char* check,
                  const std::function<void(Answer&)>& spoil) {
  for (const Answer& answer : all_answers()) {
    ASSERT_TRUE(finds_of(answer).empty());
    Answer spoilt = answer;
    spoil(spoilt);
    EXPECT_TRUE(has(finds_of(spoilt), check))
        << check << ", " << kind(answer.problem);
  }
}

int free_dof(const Answer& answer) {
  int dof = 0;
  while (answer.parts.prescribed[dof]) ++dof;
  return dof;
}

double largest(const Ref<const MatrixXd>& values) {
  return values.cwiseAbs().maxCoeff();
}

double stress_of_problem(const Answer& answer) {
  return stress_scale(answer.parts, ground_of(answer.parts, answer.estimate),
                      answer.estimate.displacement);
}

TEST(spoilt, displacement_is_out_of_balance) {
  expect_found("balance", [](Answer& a) {
    a.solution.displacement[free_dof(a)] +=
        1e-5 * largest(a.solution.displacement);
  });
}

TEST(spoilt, force_is_out_of_balance) {
  expect_found("balance", [](Answer& a) {
    const int node = pressed_node(a);
    a.solution.force(0, node) -=
        1e-6 * largest(Dense(a.parts.stiffness)) *
        displacement_scale(a.parts, a.solution.displacement);
  });
}

TEST(spoilt, support) {
  expect_found("support", [](Answer& a) {
    int dof = 0;
    while (!a.parts.prescribed[dof]) ++dof;
    a.solution.displacement[dof] += 1e-9 * largest(a.solution.displacement);
  });
}

TEST(spoilt, tension) {
  expect_found("law", [](Answer& a) {
    for (Matrix2Xd* P : {&a.solution.force, &a.solution.pressure})
      (*P)(0, pressed_node(a)) = 1e-6 * largest(*P);
  });
}

TEST(spoilt, friction) {
  expect_found("law", [](Answer& a) {
    for (Matrix2Xd* P : {&a.solution.force, &a.solution.pressure})
      (*P)(1, pressed_node(a)) +=
          10 * largest(*P) * (1 + largest(a.parts.law.friction));
  });
}

TEST(spoilt, penetration_of_the_solution) {
  expect_found("law", [](Answer& a) {
    const int node = pressed_node(a), v = a.parts.line.vertex[node];
    a.solution.displacement.segment<2>(2 * v) +=
        1e-4 * largest(a.solution.displacement) * a.parts.line.normal.col(node);
  });
}

TEST(spoilt, penetration_of_the_estimate) {
  expect_found("displacement", [](Answer& a) {
    const int node = pressed_node(a), v = a.parts.line.vertex[node];
    a.estimate.displacement.segment<2>(2 * v) +=
        2 * largest(a.estimate.displacement) * a.parts.line.normal.col(node);
  });
}

TEST(spoilt, stress_loses_its_divergence) {
  expect_found("divergence", [](Answer& a) {
    a.estimate.stress[3](0, 4) += 1e-6 * stress_of_problem(a);
  });
}

TEST(spoilt, stress_jumps) {
  expect_found("jump", [](Answer& a) {
    a.estimate.stress[3].row(2).array() += 1e-8 * stress_of_problem(a);
  });
}

TEST(spoilt, contact_traction_is_not_that_of_the_stress) {
  expect_found("traction", [](Answer& a) {
    a.estimate.tractions.normal(0, 0) -= 1e-8 * stress_of_problem(a);
  });
}

TEST(spoilt, traction_outside_the_cone) {
  expect_found("cone", [](Answer& a) {
    a.estimate.tractions.normal(1, 0) = 1e-9 * stress_of_problem(a);
  });
}

TEST(spoilt, error) {
  expect_found("error", [](Answer& a) { a.estimate.e *= 1 + 1e-6; });
  expect_found("error", [](Answer& a) { a.estimate.relative *= 1 + 1e-6; });
  expect_found("error", [](Answer& a) { a.estimate.elastic *= 1.001; });
  expect_found("error", [](Answer& a) {
    a.estimate.local[0] += 1e-3 * a.estimate.relative + 1e-5;
  });
}

TEST(spoilt, line) {
  expect_found("line", [](Answer& a) {
    a.parts.line.normal.col(0) = -a.parts.line.normal.col(0);
  });
  expect_found("line", [](Answer& a) { a.parts.line.length[0] *= 1 + 1e-6; });
}

TEST(spoilt, coupling) {
  for (const Answer& answer : all_answers()) {
    if (!answer.problem.has_opposites()) continue;
    Answer spoilt = answer;
    spoilt.parts.line.opposite.coeffRef(
        0, WeightsByNode::InnerIterator(spoilt.parts.line.opposite, 0).col()) +=
        1e-6;
    EXPECT_TRUE(has(finds_of(spoilt), "coupling"));
  }
}

/// e below the true error: with e at a hundredth no problem is left for which it might
/// still be a bound.
TEST(spoilt, bound) {
  int tried = 0;
  for (const Answer& answer : all_answers()) {
    if (answer.problem.law == Law::coulomb || answer.estimate.refinement)
      continue;
    EXPECT_TRUE(
        bound_finds(answer.problem, answer.parts, answer.estimate, 1).empty());
    Estimate<2> spoilt = answer.estimate;
    spoilt.e *= 0.01;
    spoilt.relative *= 0.01;
    EXPECT_TRUE(
        has(bound_finds(answer.problem, answer.parts, spoilt, 1), "bound"))
        << kind(answer.problem);
    ++tried;
  }
  EXPECT_GE(tried, 4);
}

/// A square on one contact edge that nothing else holds: on a linear density it stands
/// with its reaction in the middle third.
TEST(holding, by_no_density_where_a_body_stands_on_one_end) {
  Body square;
  square.mesh.vertices = (Matrix2Xd(2, 4) << 0, 1, 1, 0, 0, 0, 1, 1).finished();
  square.mesh.cells = (Matrix3Xi(3, 2) << 0, 0, 1, 2, 2, 3).finished();
  square.mesh.boundary = (Matrix2Xi(2, 4) << 0, 1, 2, 3, 1, 2, 3, 0).finished();
  square.mesh.boundary_label = Vector4i(1, 2, 3, 4);
  square.region = {0, 0};
  square.materials = {{1, 0.3}};
  Case problem;
  problem.contacts = {{0, {1}, {}}};
  ContactSolution<2> solution;
  const auto held_at = [&](double place) {
    problem.bodies = {square};
    const Assembled parts = assembled(problem);
    solution.force.setZero(2, 2);
    for (int i = 0; i < 2; ++i) {
      const double x = square.mesh.vertices(0, parts.line.vertex[i]);
      solution.force(0, i) = -(x * place + (1 - x) * (1 - place));
    }
    return !no_density_holds(parts, solution);
  };
  for (const Law law : {Law::frictionless, Law::coulomb}) {
    problem.law = law;
    problem.friction.mean = law == Law::coulomb ? 0.3 : 0;
    for (const double place : {0.35, 0.5, 0.65})
      EXPECT_TRUE(held_at(place)) << place;
    for (const double place : {0.0, 0.3, 0.7, 1.0})
      EXPECT_FALSE(held_at(place)) << place;
    for (int c = 0; c < 2; ++c) square.supports.push_back({3, c, {}});
    EXPECT_TRUE(held_at(0)) << "what is clamped elsewhere needs no contact";
    square.supports.clear();
  }
}

TEST(text, keeps_every_digit) {
  for (std::uint64_t index = 0; index < 50; ++index) {
    const std::string text = text_of(random_case(5, index));
    EXPECT_EQ(text_of(case_of(text)), text);
  }
  EXPECT_THROW(case_of("something else"), std::runtime_error);
}

TEST(messages, lose_their_numbers) {
  EXPECT_EQ(without_numbers("vertex 28 (-21.5, 2.6e-12): M'_h 3"),
            "vertex # (#, #): M'_h #");
}

}  // namespace
}  // namespace ffcontact::fuzz
