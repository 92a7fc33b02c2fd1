// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/plane_solve.hpp"

#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/mesh/crossings.hpp"
//
#include "problem/coulomb.hpp"
#include "problem/result_names.hpp"
#include "problem/systems.hpp"
#include "solve/held_motions.hpp"
#include "solve/load_step.hpp"
#include "solve/locking.hpp"
#include "solve/solve_report.hpp"
#include "solve/stated_tool.hpp"

namespace ffcontact::plugin {

namespace {

/// F = F_n n + F_t t with t = (-n_y, n_x): whose n and t it is makes no difference to F_n
/// and F_t, n and t of the body that comes first make it the force on that body.
void put_vectors(const Matrix2Xd& normal, NodalResults& results) {
  const Eigen::ArrayXd nx = normal.row(0), ny = normal.row(1);
  results.fx = results.fn.array() * nx - results.ft.array() * ny;
  results.fy = results.fn.array() * ny + results.ft.array() * nx;
}

/// Results at the nodes: pn and pt are the multipliers of M'_h, for M''_h forces over
/// lengths.
NodalResults nodal_results(const ContactProblem<2>& problem,
                           const ContactLaw<2>& law, const Flags& prescribed,
                           const ContactSolution<2>& solution) {
  const ContactLine& line = problem.contact;
  const Matrix2Xd pressure =
      law.multiplier == Multiplier::pressure
          ? solution.pressure
          : lumped_pressures(line, prescribed, solution.force);
  const Matrix2Xd moved = displacement_against_foundation(
      line, on_layer(law, lumped_pressures(line, solution.force)),
      solution.displacement);
  NodalResults results;
  results.pn = pressure.row(0);
  results.pt = pressure.row(1);
  results.fn = solution.force.row(0);
  results.ft = solution.force.row(1);
  put_vectors(problem.own_normal, results);
  results.gap = -moved.row(0);
  results.slip = moved.row(1);
  results.state = state_numbers(solution.state);
  return results;
}

/// u_t without what springs back of it.
VectorXd slid_on_layer(const ContactLine& line, const SolvedContact& solved) {
  const ContactSolution<2>& found = solved.solution;
  const Matrix2Xd pressure = lumped_pressures(line, found.force);
  return (contact_components(line, found.displacement) +
          solved.law.layer.given_way(pressure))
      .row(1);
}

/// The same against the foundation, which is where its tool has left it.
VectorXd slid(const ContactLine& line, const SolvedContact& solved) {
  const VectorXd along = slid_on_layer(line, solved);
  return solved.tool.size() > 0 ? VectorXd(along - solved.tool) : along;
}

/// Against a foundation that stays, or that its tool moves.
void solve(const SolveCall& call, const ContactProblem<2>& problem,
           const ContactSettings& settings, SolvedContact& solved) {
  const ContactLine& line = problem.contact;
  const auto tool = stated_tool(call, problem.mesh.origin);
  if (tool && solved.law.bonded)
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
  solved.tool =
      tool_components(problem.mesh, line, *tool, with_tool.motion).row(1);
  solved.motion = with_tool.motion;
  solved.driven = tool;
}

/// Of the last solution, at the nodes of this line.
ContactStates last_states(const Contact& contact) {
  ContactLine stated = contact.problem->contact;
  stated.abscissa = contact.problem->abscissa;
  return states_at(stated, contact.last_abscissa, contact.last_states);
}

ContactLaw<2> law_of(const SolveCall& call, const Contact& contact,
                     const ContactStates& last) {
  const ContactLine& line = contact.problem->contact;
  ContactLaw<2> law = contact.problem->law;
  law.multiplier = multiplier_of(call.stack, call.named);
  if (law.bonded) return law;
  return law_of_step(call, contact, line, last, std::move(law),
                     [&] { return slid(line, *contact.solved); });
}

void warn_that_triangles_lock(const ContactProblem<2>& problem,
                              const ElasticSystem& system) {
  constexpr double crossed = 0.4;  // of triangles that do not
  const auto may_lock = [&](int first, int end) {
    return crossing_share(problem.mesh, first, end) < crossed;
  };
  warn_that_cells_lock(problem.mesh, system, problem.joined.first_vertex,
                       may_lock, "triangles",
                       "use quadrangles cut by both diagonals, or "
                       "square(n, n, flags=1), which do not lock");
}

ContactSettings settings_of(const SolveCall& call, const Contact& contact,
                            const ElasticSystem& system, ContactStates last) {
  ContactSettings settings = settings_of(call, std::move(last), 2);
  settings.stiffness = known_stiffness(contact.solved, system);
  return settings;
}

}  // namespace

void put(const SolveCall& call, const std::vector<long>& own_vertex,
         const VectorXd& abscissa, const NodalResults& nodes) {
  put(call, own_vertex, nodes);
  call.named.put(call.stack, "abscissa", abscissa);
}

long solve_plane(const SolveCall& call, Contact& contact) {
  require_plane_results(call.named);
  ContactProblem<2>& problem = *contact.problem;
  SolvedContact solved;
  const MatrixXd sliding = put_system(call, contact, solved);
  const ElasticSystem& system = *solved.system;
  const ContactStates last = last_states(contact);
  solved.law = law_of(call, contact, last);
  const ContactSettings settings = settings_of(call, contact, system, last);
  // a system that is at hand has been asked
  if (!settings.stiffness) warn_that_triangles_lock(problem, system);
  try {
    solve(call, problem, settings, solved);
  } catch (const NoEquilibrium& none) {
    answer_no_equilibrium(call, problem.joined.first_vertex, none);
    return 0;
  }
  take_out(problem.mesh, sliding, solved.solution.displacement);
  const ContactSolution<2>& solution = solved.solution;
  if (!solution.accepted(settings) && !call.named.given("status"))
    refuse_solution(
        answer_of(solution),
        advice_on_held(problem.joined.first_vertex, problem.contact, system));

  write_displacement(call, problem, solution.displacement);
  solved.nodes =
      nodal_results(problem, solved.law, system.prescribed, solution);
  put(call, problem.own_vertex, problem.abscissa, solved.nodes);
  call.named.put(call.stack, "tool", solved.motion);
  put(call, answer_of(solution));
  report_solution(call, problem, problem.side, answer_of(solution));
  report_friction(call.verbosity(), problem, solved);
  contact.last_states = states_for_next(
      problem, solved, solved.nodes.slip.cwiseAbs(), settings.tolerance);
  contact.last_abscissa = problem.abscissa;
  contact.solved = std::move(solved);
  return contact.solved->solution.iterations;
}

}  // namespace ffcontact::plugin
