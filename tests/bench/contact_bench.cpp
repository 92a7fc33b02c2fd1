// SPDX-License-Identifier: GPL-3.0-or-later
// A contact problem, all of solve_contact on an ElasticSystem, beside one linear solve of
// the same matrix: example 1 of [CHH01] on finer grids, with both multipliers. Times are
// the shortest of five runs in random order; memory is the peak of a process of its own
// on top of mesh and matrix.
#include "comparison.hpp"
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
    ContactLaw law = body.law;
    law.multiplier = multiplier;
    return [&body, &system, law] {
      const ContactSettings settings;
      if (!solve_contact(body.mesh, body.line, law, system, settings)
               .accepted(settings))
        throw std::runtime_error("the contact problem is not solved");
    };
  };
}

}  // namespace ffcontact::bench

int main(int argc, char** argv) {
  using namespace ffcontact::bench;
  using ffcontact::Multiplier;
  return compare(argc, argv,
                 {{"linear solve", linear_solve},
                  {"contact, forces", contact(Multiplier::force)},
                  {"contact, pressures", contact(Multiplier::pressure)}},
                 {122, 250, 500});
}
