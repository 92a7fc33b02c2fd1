// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "ffcontact/mesh/crossings.hpp"
//
#include "problem/coulomb.hpp"
#include "solve/contact_solve_of.hpp"
#include "solve/stated_tool.hpp"

namespace ffcontact::plugin {

template <>
void SolveOf<2>::require_parameters(const SolveCall&) {}

template <>
void SolveOf<2>::warn_that_cells_lock(const ContactProblem<2>& problem,
                                      const ElasticSystem& system) {
  constexpr double crossed = 0.4;  // of triangles that do not
  const auto may_lock = [&](int first, int end) {
    return crossing_share(problem.mesh, first, end) < crossed;
  };
  plugin::warn_that_cells_lock(
      problem.mesh, system, problem.joined.first_vertex, may_lock, "triangles",
      "use quadrangles cut by both diagonals, or square(n, n, flags=1), which "
      "do not lock");
}

template <>
void SolveOf<2>::find(const SolveCall& call, const ContactProblem<2>& problem,
                      const ContactSettings& settings,
                      SolvedContact<2>& solved) {
  const ContactLine& line = problem.contact;
  const auto tool = stated_tool(call, problem.mesh.origin);
  if (tool && solved.law.has_bonded())
    refuse(
        "push= and moment= move a foundation that bodies lie on: where they "
        "are bonded to it, give the foundation as a body, or its displacement "
        "by on()");
  if (!tool) {
    solved.solution =
        solve_contact(problem.mesh, line, solved.law, *solved.system, settings);
    return;
  }
  ToolSolution with_tool = solve_contact_with_tool(
      problem.mesh, line, solved.law, *solved.system, *tool, settings);
  solved.law = std::move(with_tool.law);
  solved.solution = std::move(with_tool.solution);
  solved.moved = {
      *tool, with_tool.motion,
      tool_components(problem.mesh, line, *tool, with_tool.motion).row(1)};
}

/// The multipliers of M'_h, for M''_h forces over lengths.
template <>
Matrix2Xd SolveOf<2>::pressures(const ContactProblem<2>& problem,
                                const SolvedContact<2>& solved) {
  return solved.law.multiplier == Multiplier::pressure
             ? solved.solution.pressure
             : lumped_pressures(problem.contact, solved.system->prescribed,
                                solved.solution.force);
}

template <>
VectorXd SolveOf<2>::abscissa(const ContactProblem<2>& problem) {
  return problem.abscissa;
}

template <>
void SolveOf<2>::report(const SolveCall& call, const ContactProblem<2>& problem,
                        const SolvedContact<2>& solved) {
  report_friction(call.verbosity(), problem, solved);
}

template long solve_here(const SolveCall&, ContactOf<2>&);

}  // namespace ffcontact::plugin
