// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_report.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ffcontact/base/require.hpp"
//
#include "coulomb.hpp"

namespace ffcontact::plugin {

namespace {

/// What the script can do about a solve that failed.
const char* remedy(ContactStatus status) {
  switch (status) {
    case ContactStatus::not_converged: return "; raise maxit=";
    case ContactStatus::cycled:
      return "; lower friction=, or bring the load in steps with loadstep=true";
    case ContactStatus::singular:
      return "; prescribe displacements or give friction= that hold the body";
    default: return "; raise tol= if this is accurate enough";
  }
}

/// Does no free dof of the node's vertex move it along its normal?
bool is_held_along_normal(const ContactLine& line, const ElasticSystem& system,
                          int node) {
  constexpr double tangential = 1e-3;
  for (int c = 0; c < 2; ++c)
    if (!system.prescribed[2 * line.vertex[node] + c] &&
        std::abs(line.normal(c, node)) > tangential)
      return false;
  return true;
}

int number_in_its_mesh(const JoinedMesh& joined, int vertex) {
  return vertex -
         *std::prev(std::upper_bound(joined.first_vertex.begin(),
                                     joined.first_vertex.end() - 1, vertex));
}

/// The vertices of the line whose normal dof is prescribed, as their meshes number them.
std::vector<int> held_vertices(const ContactProblem& problem,
                               const ElasticSystem& system) {
  std::vector<int> held;
  for (int i = 0; i < problem.line.node_count(); ++i)
    if (is_held_along_normal(problem.line, system, i))
      held.push_back(
          number_in_its_mesh(problem.joined, problem.line.vertex[i]));
  return held;
}

/// The first numbers of many.
std::string listed(const std::vector<int>& numbers) {
  constexpr std::size_t most = 8;
  std::ostringstream list;
  for (std::size_t k = 0; k < std::min(most, numbers.size()); ++k)
    list << (k > 0 ? ", " : "") << numbers[k];
  return list.str() + (numbers.size() > most ? ", ..." : "");
}

/// Part of a sentence that names held vertices.
std::string advice_on(const std::vector<int>& held) {
  if (held.empty()) return "";
  return "; on() prescribes the normal displacement on the contact line at "
         "vertex " +
         listed(held) +
         ": leave it free there, or take these edges out of label=";
}

/// Part of a sentence that says which side of each pair of bodies carries the
/// multipliers.
std::string sides(const ContactProblem& problem) {
  std::ostringstream text;
  for (std::size_t k = 0; k < problem.side.size(); ++k)
    text << (k > 0 ? ", " : " on side ") << problem.side[k];
  return text.str();
}

void report_details(const ContactSolution& solution) {
  if (!solution.history.empty())
    cout << "contactsolve: " << solution.history.size()
         << " steps of the fixed point, last change of the normal multipliers "
         << solution.history.back() << endl;
  cout << "contactsolve: violation " << solution.complementarity
       << ", residual " << solution.residual << endl;
}

}  // namespace

Counts counted(const std::vector<ContactState>& states) {
  Counts counts;
  for (ContactState state : states)
    ++(state == ContactState::open    ? counts.open
       : state == ContactState::stick ? counts.stick
                                      : counts.slip);
  return counts;
}

void refuse_solution(const ContactProblem& problem, const ElasticSystem& system,
                     const ContactSolution& solution) {
  refuse("no solution after ", solution.iterations, " iterations (",
         in_words(solution.status), "), largest violation ",
         solution.complementarity, ", residual ", solution.residual,
         remedy(solution.status), "; status= returns the best iterate instead",
         advice_on(held_vertices(problem, system)));
}

void report_solution(long level, const ContactProblem& problem,
                     const ContactSolution& solution, double seconds) {
  if (level < 1 || mpirank != 0) return;
  const Counts counts = counted(solution.state);
  cout << "contactsolve: " << 2 * problem.mesh.vertex_count() << " dofs, "
       << problem.line.node_count() << " contact nodes" << sides(problem)
       << ", " << solution.iterations << " iterations, " << counts.open
       << " open, " << counts.stick << " stick, " << counts.slip << " slip, "
       << in_words(solution.status) << ", " << seconds << " s" << endl;
  if (level > 1) report_details(solution);
}

void report_friction(long level, const ContactProblem& problem,
                     const SolvedContact& solved) {
  constexpr double near = 0.01;
  if (level < 1 || mpirank != 0) return;
  const double mu = largest_friction(nodal_law(solved.law, problem.line));
  if (mu == 0 || solved.solution.status != ContactStatus::converged) return;
  const double critical = critical_friction_of(problem, solved);
  if (mu < (1 - near) * critical) return;
  cout << "contactsolve: friction " << mu
       << (mu > (1 + near) * critical ? " is beyond " : " is within 1 % of ")
       << critical
       << ", where the solution with these open, sticking and slipping nodes "
          "is not the only one"
       << endl;
}

}  // namespace ffcontact::plugin
