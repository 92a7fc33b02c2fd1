// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ffcontact/contact/checks/unbalanced_motion.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

/// What contactsolve says of a solution, and of its failure.
namespace ffcontact::plugin {

/// Contact nodes by their states.
struct Counts {
  long open = 0, stick = 0, slip = 0;
};
Counts counted(const ContactStates& states);

/// What is said of a solution.
struct SolveAnswer {
  ContactStatus status;
  int iterations, products;
  double violation, residual;
  std::vector<double> history;
  Counts counts;
};
template <int d>
SolveAnswer answer_of(const ContactSolution<d>& solution) {
  return {solution.status,          solution.iterations, solution.products,
          solution.complementarity, solution.residual,   solution.history,
          counted(solution.state)};
}

/// violation=, status=, history=, opennodes=, sticknodes=, slipnodes=
void put(const SolveCall& call, const SolveAnswer& answer);

/// Part of a sentence that names the vertices that on() holds along their normals.
/// @param first_vertex  of each body
/// @param vertex        of each node [p]
/// @param normal        contact directions [d x p]
std::string advice_on_held(const std::vector<int>& first_vertex,
                           const VectorXi& vertex, const MatrixXd& normal,
                           const ElasticSystem& system);

/// Refuses a solution that was not accepted, with what the script can do about it.
[[noreturn]] void refuse_solution(const SolveAnswer& answer,
                                  const std::string& advice);

/// Loads that nothing balances: status= and the sentence at verbosity 1.
/// @param first_vertex  of each body, which is named by its number where there are several
/// @throws std::invalid_argument  if the script does not ask for status=
void answer_no_equilibrium(const SolveCall& call,
                           const std::vector<int>& first_vertex,
                           const NoEquilibrium& none);

/// By verbosity: one line at 1, details above.
/// @param side  of each pair of bodies
void report_solution(const SolveCall& call, const BodyDofs& bodies,
                     const std::vector<long>& side, const SolveAnswer& answer);

/// Says that a second solution is near or may exist (critical_friction), but not of
/// curves that the statement has warned of.
void report_friction(long level, const ContactProblem<2>& problem,
                     const SolvedContact<2>& solved);

}  // namespace ffcontact::plugin
