// SPDX-License-Identifier: GPL-3.0-or-later
// The error estimate with two sweeps and all outputs beside one linear solve of the same
// matrix: example 1 of [CHH01] on finer grids, multiplier force. Set OMP_NUM_THREADS for
// the number of threads.
#include "comparison.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "linear_solve.hpp"

namespace ffcontact::bench {

std::function<void()> linear_solve(int n) {
  const auto solve = std::make_shared<LinearSolve>(elastic_system_of(n));
  return [solve] { solve->run(); };
}

SolvedBody<2> solved_body(const test::Problem& problem,
                          const ElasticSystem& system) {
  const ContactSolution<2> solution =
      solve_contact(problem.mesh, problem.line, problem.law, system);
  SolvedBody<2> body;
  body.hooke = problem.hooke;
  body.displacement = solution.displacement;
  body.multipliers = solution.pressure;
  body.law = problem.law;
  body.neumann = problem.neumann;
  body.body_loads = BodyLoadsOfCells<2>::Zero(6, problem.mesh.cells.cols());
  body.stiffness = solution.stiffness;
  return body;
}

std::function<void()> estimate(int n) {
  static std::map<int, SolvedBody<2>> bodies;
  static std::map<int, Topology<2>> topologies;
  const test::Problem& body = problem(n);
  const ElasticSystem& system = elastic_system_of(n);
  if (!bodies.count(n)) {
    bodies.emplace(n, solved_body(body, system));
    topologies.emplace(n, topology_of(body.mesh));
  }
  return
      [&body, &system, &solved = bodies.at(n), &topology = topologies.at(n)] {
        EstimateSettings<2> settings;
        settings.relaxation.steps = 2;
        const Estimate<2> result =
            estimate_error(topology, body.line, system, solved, settings);
        benchmark::DoNotOptimize(result.e);
      };
}

}  // namespace ffcontact::bench

int main(int argc, char** argv) {
  using namespace ffcontact::bench;
  return compare(
      argc, argv,
      {{"linear solve", linear_solve}, {"estimate, 2 sweeps", estimate}},
      {122, 250, 500});
}
