// SPDX-License-Identifier: GPL-3.0-or-later
// A contact problem, all of solve_contact on an ElasticSystem, beside one linear solve of
// the same matrix: example 1 of [CHH01] on finer grids, with both multipliers. Times are
// the shortest of five runs in random order; memory is the peak of a process of its own
// on top of mesh and matrix.
#include "comparison.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"
#include "ffcontact/contact/uniqueness/critical_friction.hpp"
#include "linear_solve.hpp"

namespace ffcontact::bench {

std::function<void()> linear_solve(int n) {
  const auto solve = std::make_shared<LinearSolve>(elastic_system_of(n));
  return [solve] { solve->run(); };
}

Case contact(Multiplier multiplier) {
  return [multiplier](int n) {
    const test::Problem& body = problem(n);
    const ElasticSystem& system = elastic_system_of(n);
    ContactLaw<2> law = body.law;
    law.multiplier = multiplier;
    return [&body, &system, law] {
      const ContactSettings settings;
      if (!solve_contact(body.mesh, body.line, law, system, settings)
               .accepted(settings))
        throw std::runtime_error("the contact problem is not solved");
    };
  };
}

/// What a solution tells of Coulomb's law: kappa, and the critical coefficient.
std::function<void()> coulomb(int n) {
  static std::map<int, ContactSolution<2>> solutions;
  const test::Problem& body = problem(n);
  if (!solutions.count(n))
    solutions.emplace(
        n, solve_contact(body.mesh, body.line, body.law, elastic_system_of(n)));
  return [&body, &solution = solutions.at(n)] {
    const NodalLaw law = nodal_law(body.law, body.line);
    const Matrix2Xd w = displacement_against_foundation(body.line, body.law,
                                                        solution.displacement);
    benchmark::DoNotOptimize(coulomb_constant(
        *solution.contact,
        slip_pattern(law, solution.force, solution.force, w.row(1)),
        largest_friction(law), StuckNodes::may_slip));
    benchmark::DoNotOptimize(critical_friction(
        *solution.contact, law, solution.state, solution.force.reshaped()));
  };
}

}  // namespace ffcontact::bench

int main(int argc, char** argv) {
  using namespace ffcontact::bench;
  using ffcontact::Multiplier;
  return compare(argc, argv,
                 {{"linear solve", linear_solve},
                  {"contact, forces", contact(Multiplier::force)},
                  {"contact, pressures", contact(Multiplier::pressure)},
                  {"kappa and critical friction", coulomb}},
                 {122, 250, 500});
}
