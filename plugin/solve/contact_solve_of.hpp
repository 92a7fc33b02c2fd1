// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/solve_contact.hpp"
//
#include "problem/result_names.hpp"
#include "problem/systems.hpp"
#include "solve/contact_solve.hpp"
#include "solve/held_motions.hpp"
#include "solve/last_nodes.hpp"
#include "solve/load_step.hpp"
#include "solve/locking.hpp"
#include "solve/other_mesh.hpp"
#include "solve/solve_report.hpp"

/// The body of solve_here.
namespace ffcontact::plugin {

/// What differs between plane bodies and solids.
template <int d>
struct SolveOf {
  /// @throws std::invalid_argument  if the call has what is for bodies of the other dimension
  static void require_parameters(const SolveCall& call);
  static void warn_that_cells_lock(const ContactProblem<d>& problem,
                                   const ElasticSystem& system);
  /// Puts solution, law and tool into `solved`.
  static void find(const SolveCall& call, const ContactProblem<d>& problem,
                   const ContactSettings& settings, SolvedContact<d>& solved);
  /// Pressures that scripts see [d x p].
  static Matrix<double, d, Dynamic> pressures(const ContactProblem<d>& problem,
                                              const SolvedContact<d>& solved);
  static VectorXd abscissa(const ContactProblem<d>& problem);
  /// What is said of the solution besides.
  static void report(const SolveCall& call, const ContactProblem<d>& problem,
                     const SolvedContact<d>& solved);
};

/// Components on the body that carries the multipliers as those on the body that comes first:
/// n turns with it, as does u, and so do t and t2 = t1 x n, but t1 keeps its direction.
template <int d>
Matrix<double, d, Dynamic> own_components(
    const VectorXd& sign, Matrix<double, d, Dynamic> components) {
  if constexpr (d == 3) components.row(1).array() *= sign.transpose().array();
  return components;
}

/// @param displaced  against the foundation or the other body [d x p]
template <int d>
NodalResults nodal_results(const ContactProblem<d>& problem,
                           const SolvedContact<d>& solved,
                           const Matrix<double, d, Dynamic>& displaced) {
  const Matrix<double, d, Dynamic>& force = solved.solution.force;
  const VectorXd sign = problem.own_signs();
  const auto moved = own_components<d>(sign, displaced);
  NodalResults results(problem.contact.node_count(), d);
  results.pressure() =
      own_components<d>(sign, SolveOf<d>::pressures(problem, solved))
          .transpose();
  results.force() = own_components<d>(sign, force).transpose();
  results.vector() = own_vectors<d>(problem, force).transpose();
  results.gap() = -moved.row(0).transpose();
  results.slip() = moved.template bottomRows<d - 1>().transpose();
  results.state = state_numbers(solved.solution.state);
  return results;
}

template <int d>
ContactSettings settings_of(const SolveCall& call, const ContactOf<d>& contact,
                            const SolvedContact<d>& solved, Guess last) {
  ContactSettings settings = settings_of(call, std::move(last.state), d);
  settings.stiffness = known_stiffness(contact, *solved.system);
  if (call.named.given("initial")) return settings;
  settings.state_of_another_mesh = !contact.solved;
  // how a step slipped says little of the next one
  if (d == 3 && solved.law.previous.size() == 0)
    settings.near = std::move(last.rows);
  return settings;
}

/// What is solved, and from what.
template <int d>
ContactSettings put_problem(const SolveCall& call, const ContactOf<d>& contact,
                            SolvedContact<d>& solved) {
  const ContactProblem<d>& problem = *contact.problem;
  Guess last = guess_at(problem, contact.last);
  ContactLaw<d> law = problem.law;
  if constexpr (d == 2) law.multiplier = multiplier_of(call.stack, call.named);
  solved.law = law.slides_nowhere()
                   ? law
                   : law_of_step(call, contact, last.state, std::move(law));
  ContactSettings settings =
      settings_of(call, contact, solved, std::move(last));
  // a system that is at hand has been asked
  if (!settings.stiffness) {
    warn_of_other_mesh(problem.mesh, *solved.system,
                       problem.joined.first_vertex);
    SolveOf<d>::warn_that_cells_lock(problem, *solved.system);
  }
  return settings;
}

template <int d>
void require_accepted(const SolveCall& call, const ContactProblem<d>& problem,
                      const SolvedContact<d>& solved,
                      const ContactSettings& settings) {
  if (solved.solution.accepted(settings) || call.named.given("status")) return;
  refuse_solution(
      answer_of(solved.solution),
      advice_on_held(problem.joined.first_vertex, problem.contact.vertex,
                     problem.contact.normal, *solved.system));
}

template <int d>
void put(const SolveCall& call, const ContactProblem<d>& problem,
         const SolvedContact<d>& solved) {
  const SolveAnswer answer = answer_of(solved.solution);
  write_displacement(call, problem, solved.solution.displacement);
  put(call, problem.own_vertex, SolveOf<d>::abscissa(problem), solved.nodes);
  call.named.put(call.stack, "tool",
                 solved.moved ? solved.moved->motion : VectorXd());
  put(call, answer);
  report_solution(call, problem, problem.side, answer);
  SolveOf<d>::report(call, problem, solved);
}

template <int d>
long solve_here(const SolveCall& call, ContactOf<d>& contact) {
  require_results_of(d, call.named);
  SolveOf<d>::require_parameters(call);
  SolvedContact<d> solved;
  const MatrixXd sliding = put_system(call, contact, solved);
  const ContactProblem<d>& problem = *contact.problem;
  const ContactSettings settings = put_problem(call, contact, solved);
  try {
    SolveOf<d>::find(call, problem, settings, solved);
  } catch (const NoEquilibrium& none) {
    answer_no_equilibrium(call, problem.joined.first_vertex, none);
    return 0;
  }
  take_out(problem.mesh, sliding, solved.solution.displacement);
  require_accepted(call, problem, solved, settings);
  const auto moved = displaced(problem, solved);
  solved.nodes = nodal_results(problem, solved, moved);
  put(call, problem, solved);
  contact.last = last_nodes(problem, solved, moved, settings.tolerance);
  contact.solved = std::move(solved);
  return contact.solved->solution.iterations;
}

}  // namespace ffcontact::plugin
