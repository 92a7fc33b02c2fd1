// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/contact_solve_of.hpp"
#include "solve/stated_tool.hpp"

namespace ffcontact::plugin {

template <>
void SolveOf<3>::require_parameters(const SolveCall& call) {
  require_no_tool(call.named);
  if (multiplier_of(call.stack, call.named) == Multiplier::pressure)
    refuse(
        "multiplier=\"pressure\" is for plane bodies: leave it out, "
        "solids have nodal forces");
}

template <>
void SolveOf<3>::warn_that_cells_lock(const ContactProblem<3>& problem,
                                      const ElasticSystem& system) {
  plugin::warn_that_cells_lock(
      problem.mesh, system, problem.joined.first_vertex,
      [](int, int) { return true; }, "tetrahedra", "refine until eps is small");
}

template <>
void SolveOf<3>::find(const SolveCall&, const ContactProblem<3>& problem,
                      const ContactSettings& settings,
                      SolvedContact<3>& solved) {
  solved.solution = solve_contact(problem.mesh, problem.contact, solved.law,
                                  *solved.system, settings);
}

template <>
Matrix3Xd SolveOf<3>::pressures(const ContactProblem<3>& problem,
                                const SolvedContact<3>& solved) {
  return lumped_pressures(problem.contact, solved.solution.force);
}

template <>
VectorXd SolveOf<3>::abscissa(const ContactProblem<3>&) {
  return {};
}

template <>
void SolveOf<3>::report(const SolveCall& call, const ContactProblem<3>&,
                        const SolvedContact<3>& solved) {
  if (solved.solution.multigrid != Multigrid::in_vain || call.verbosity() < 1 ||
      mpirank != 0)
    return;
  cout << "contactsolve: multigrid does not converge here, as with nu near 0.5 "
          "or cells of no volume, and a factor took its place; "
          "solver=\"direct\" saves the attempt"
       << endl;
}

template long solve_here(const SolveCall&, ContactOf<3>&);

}  // namespace ffcontact::plugin
