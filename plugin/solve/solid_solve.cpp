// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solid_solve.hpp"

#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/contact/solve_contact.hpp"
//
#include "problem/contact_type.hpp"
#include "problem/result_names.hpp"
#include "problem/systems.hpp"
#include "solve/held_motions.hpp"
#include "solve/load_step.hpp"
#include "solve/locking.hpp"
#include "solve/solve_report.hpp"
#include "solve/stated_tool.hpp"

namespace ffcontact::plugin {

namespace {

/// Of components along n, t1, t2 at the nodes [3 x p].
Matrix3Xd vectors(const ContactSurface& surface, const Matrix3Xd& components) {
  Matrix3Xd vectors(3, surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i)
    vectors.col(i) = surface.frame(i) * components.col(i);
  return vectors;
}

SolidResults nodal_results(const ContactSurface& surface,
                           const ContactLaw<3>& law,
                           const ContactSolution<3>& solution) {
  const Matrix3Xd& force = solution.force;
  const Matrix3Xd pressure = lumped_pressures(surface, force);
  const Matrix3Xd vector = vectors(surface, force);
  const Matrix3Xd moved = displacement_against_foundation(
      surface, on_layer(law, pressure), solution.displacement);
  SolidResults results;
  results.pn = pressure.row(0);
  results.pt1 = pressure.row(1);
  results.pt2 = pressure.row(2);
  results.fn = force.row(0);
  results.ft1 = force.row(1);
  results.ft2 = force.row(2);
  results.fx = vector.row(0);
  results.fy = vector.row(1);
  results.fz = vector.row(2);
  results.gap = -moved.row(0);
  results.slip1 = moved.row(1);
  results.slip2 = moved.row(2);
  results.state = state_numbers(solution.state);
  return results;
}

/// The nearest old node of each new one; where sheets meet at an edge several are at one
/// place, and a normal that is turned counts as a distance of the node's size.
std::vector<Index> nearest_nodes(const ContactProblem<3>& problem,
                                 const PlacedAnswer& old) {
  const Matrix3Xd place = problem.places();
  const ContactSurface& surface = problem.contact;
  std::vector<Index> nearest(surface.node_count());
  for (int i = 0; i < surface.node_count(); ++i) {
    const Eigen::RowVectorXd square =
        (old.place.colwise() - place.col(i)).colwise().squaredNorm() +
        surface.area[i] * (old.normal.colwise() - surface.normal.col(i))
                              .colwise()
                              .squaredNorm();
    square.minCoeff(&nearest[i]);
  }
  return nearest;
}

/// The last answer at the nodes of a problem.
struct Guess {
  ContactStates state;
  std::optional<ContactRows> rows;
};
Guess guess_at(const ContactProblem<3>& problem, const PlacedAnswer& old) {
  Guess guess;
  if (old.state.empty()) return guess;
  const ContactSurface& surface = problem.contact;
  Matrix3Xd P(3, surface.node_count()), v(3, surface.node_count());
  const std::vector<Index> nearest = nearest_nodes(problem, old);
  for (int i = 0; i < surface.node_count(); ++i) {
    const Matrix3d to_components = surface.frame(i).transpose();
    guess.state.push_back(old.state[nearest[i]]);
    P.col(i) = surface.area[i] * to_components * old.pressure.col(nearest[i]);
    v.col(i) = to_components * old.moved.col(nearest[i]);
  }
  guess.rows = {P.reshaped(), v.reshaped()};
  return guess;
}

void require_forces(const SolveCall& call) {
  if (multiplier_of(call.stack, call.named) == Multiplier::pressure)
    refuse(
        "multiplier=\"pressure\" is for plane bodies: leave it out, "
        "solids have nodal forces");
}

/// |v_t|
VectorXd slip_of(const SolidResults& nodes) {
  const Eigen::ArrayXd slip1 = nodes.slip1, slip2 = nodes.slip2;
  return (slip1.square() + slip2.square()).sqrt();
}

PlacedAnswer placed_answer(const ContactProblem<3>& problem,
                           const SolvedSolid& solved, double tolerance) {
  const ContactSurface& surface = problem.contact;
  const SolidResults& nodes = solved.nodes;
  Matrix3Xd pressure(3, surface.node_count()), moved(3, surface.node_count());
  pressure << nodes.pn.transpose(), nodes.pt1.transpose(),
      nodes.pt2.transpose();
  moved << -nodes.gap.transpose(), nodes.slip1.transpose(),
      nodes.slip2.transpose();
  return {states_for_next(problem, solved, slip_of(solved.nodes), tolerance),
          problem.places(),
          surface.normal,
          vectors(surface, pressure),
          vectors(surface, moved),
          problem.side};
}

/// u_t without what springs back of it.
Matrix2Xd slid(const ContactSurface& surface, const SolvedSolid& solved) {
  const ContactSolution<3>& found = solved.solution;
  const Matrix3Xd moved =
      contact_components(surface, found.displacement) +
      solved.law.layer.given_way(lumped_pressures(surface, found.force));
  return moved.bottomRows<2>();
}

ContactLaw<3> law_of(const SolveCall& call, const SolidContact& contact,
                     const ContactStates& last) {
  const ContactSurface& surface = contact.problem->contact;
  return law_of_step(call, contact, surface, last, contact.problem->law,
                     [&] { return slid(surface, *contact.solved); });
}

void report_multigrid(const SolveCall& call, Multigrid multigrid) {
  if (multigrid != Multigrid::in_vain || call.verbosity() < 1 || mpirank != 0)
    return;
  cout << "contactsolve: multigrid does not converge here, as with nu near 0.5 "
          "or cells of no volume, and a factor took its place; "
          "solver=\"direct\" saves the attempt"
       << endl;
}

ContactSettings settings_of(const SolveCall& call, const SolidContact& contact,
                            const ElasticSystem& system, Guess last) {
  ContactSettings settings = settings_of(call, std::move(last.state), 3);
  if (!call.named.given("initial")) {
    settings.state_of_another_mesh = !contact.solved;
    settings.near = std::move(last.rows);
  }
  settings.stiffness = known_stiffness(contact.solved, system);
  return settings;
}

}  // namespace

long solve_solid(const SolveCall& call, SolidContact& contact) {
  require_solid_results(call.named);
  require_no_tool(call.named);
  require_forces(call);
  ContactProblem<3>& problem = *contact.problem;
  SolvedSolid solved;
  const MatrixXd sliding = put_system(call, contact, solved);
  const ElasticSystem& system = *solved.system;
  Guess last = guess_at(problem, contact.last);
  solved.law = law_of(call, contact, last.state);
  const ContactLaw<3>& law = solved.law;
  // how a step slipped says little of the next one, and vectors turn with the side
  if (law.previous.size() > 0 || problem.side != contact.last.side)
    last.rows.reset();
  const ContactSettings settings =
      settings_of(call, contact, system, std::move(last));
  // a system that is at hand has been asked
  if (!settings.stiffness)
    warn_that_cells_lock(
        problem.mesh, system, problem.joined.first_vertex,
        [](int, int) { return true; }, "tetrahedra",
        "refine until eps is small");
  try {
    solved.solution =
        solve_contact(problem.mesh, problem.contact, law, system, settings);
  } catch (const NoEquilibrium& none) {
    answer_no_equilibrium(call, problem.joined.first_vertex, none);
    return 0;
  }
  take_out(problem.mesh, sliding, solved.solution.displacement);
  const ContactSolution<3>& solution = solved.solution;
  if (!solution.accepted(settings) && !call.named.given("status"))
    refuse_solution(
        answer_of(solution),
        advice_on_held(problem.joined.first_vertex, problem.contact, system));

  write_displacement(call, problem, solution.displacement);
  solved.nodes = nodal_results(problem.contact, law, solution);
  put(call, problem.own_vertex, solved.nodes);
  put(call, answer_of(solution));
  report_solution(call, problem, problem.side, answer_of(solution));
  report_multigrid(call, solution.multigrid);
  contact.last = placed_answer(problem, solved, settings.tolerance);
  contact.solved = std::move(solved);
  return contact.solved->solution.iterations;
}

}  // namespace ffcontact::plugin
