// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solve_report.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
//
#include "problem/coulomb.hpp"

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

/// Does no free dof of a vertex move it along n?
bool is_held_along(const VectorXd& n, const ElasticSystem& system, int vertex) {
  constexpr double tangential = 1e-3;
  for (Index c = 0; c < n.size(); ++c)
    if (!system.prescribed[n.size() * vertex + c] &&
        std::abs(n[c]) > tangential)
      return false;
  return true;
}

/// The body that a vertex of the joined mesh belongs to.
int body_of(const std::vector<int>& first_vertex, int vertex) {
  const auto first = first_vertex.begin();
  return static_cast<int>(
      std::upper_bound(first, first_vertex.end() - 1, vertex) - first - 1);
}

int number_in_its_mesh(const std::vector<int>& first_vertex, int vertex) {
  return vertex - first_vertex[body_of(first_vertex, vertex)];
}

/// The vertices of the nodes whose normal dof is prescribed, as their meshes number them.
std::vector<int> held_vertices(const std::vector<int>& first_vertex,
                               const VectorXi& vertex, const MatrixXd& normal,
                               const ElasticSystem& system) {
  std::vector<int> held;
  for (Index i = 0; i < vertex.size(); ++i)
    if (is_held_along(normal.col(i), system, vertex[i]))
      held.push_back(number_in_its_mesh(first_vertex, vertex[i]));
  return held;
}

/// The first numbers of many.
std::string listed_vertices(const std::vector<int>& numbers) {
  constexpr std::size_t most = 8;
  std::ostringstream list;
  for (std::size_t k = 0; k < std::min(most, numbers.size()); ++k)
    list << (k > 0 ? ", " : "") << numbers[k];
  return list.str() + (numbers.size() > most ? ", ..." : "");
}

/// Part of a sentence that says which side of each pair of bodies carries the
/// multipliers.
std::string sides(const std::vector<long>& side) {
  std::ostringstream text;
  for (std::size_t k = 0; k < side.size(); ++k)
    text << (k > 0 ? ", " : " on side ") << side[k];
  return text.str();
}

void report_details(const SolveAnswer& answer) {
  if (!answer.history.empty())
    cout << "contactsolve: " << answer.history.size()
         << " steps of the fixed point, last change of the normal multipliers "
         << answer.history.back() << endl;
  cout << "contactsolve: violation " << answer.violation << ", residual "
       << answer.residual << endl;
}

/// Of multigrid.
std::string products_of(const SolveAnswer& answer) {
  if (answer.products == 0) return {};
  return " of " + std::to_string(answer.products) + " products";
}

}  // namespace

Counts counted(const ContactStates& states) {
  Counts counts;
  for (ContactState state : states)
    ++(state == ContactState::open    ? counts.open
       : state == ContactState::stick ? counts.stick
                                      : counts.slip);
  return counts;
}

void put(const SolveCall& call, const SolveAnswer& answer) {
  const NamedArguments& named = call.named;
  named.put(call.stack, "violation", answer.violation);
  named.put(call.stack, "status", static_cast<long>(answer.status));
  named.put(call.stack, "history", packed(answer.history));
  named.put(call.stack, "opennodes", answer.counts.open);
  named.put(call.stack, "sticknodes", answer.counts.stick);
  named.put(call.stack, "slipnodes", answer.counts.slip);
}

std::string advice_on_held(const std::vector<int>& first_vertex,
                           const VectorXi& vertex, const MatrixXd& normal,
                           const ElasticSystem& system) {
  const std::vector<int> held =
      held_vertices(first_vertex, vertex, normal, system);
  if (held.empty()) return "";
  const bool plane = normal.rows() == 2;
  return std::string("; on() prescribes the normal displacement on the ") +
         (plane ? "contact line" : "contact surface") + " at vertex " +
         listed_vertices(held) + ": leave it free there, or take these " +
         (plane ? "edges" : "faces") + " out of label=";
}

void refuse_solution(const SolveAnswer& answer, const std::string& advice) {
  refuse("no solution after ", answer.iterations, " iterations (",
         in_words(answer.status), "), largest violation ", answer.violation,
         ", residual ", answer.residual, remedy(answer.status),
         "; status= returns the best iterate instead", advice);
}

void answer_no_equilibrium(const SolveCall& call,
                           const std::vector<int>& first_vertex,
                           const NoEquilibrium& none) {
  constexpr long no_equilibrium = 5;
  std::string sentence = none.what();
  if (first_vertex.size() > 2)
    sentence.replace(
        sentence.find(none.who), none.who.size(),
        "body " + std::to_string(body_of(first_vertex, none.vertex) + 1));
  if (!call.named.given("status")) refuse(sentence);
  call.named.put(call.stack, "status", no_equilibrium);
  if (call.verbosity() > 0 && mpirank == 0)
    cout << "contactsolve: " << sentence << endl;
}

void report_solution(const SolveCall& call, const BodyDofs& bodies,
                     const std::vector<long>& side, const SolveAnswer& answer) {
  if (call.verbosity() < 1 || mpirank != 0) return;
  const auto& [open, stick, slip] = answer.counts;
  cout << "contactsolve: " << bodies.dof_count() << " dofs, "
       << open + stick + slip << " contact nodes" << sides(side) << ", "
       << answer.iterations << " iterations" << products_of(answer) << ", "
       << open << " open, " << stick << " stick, " << slip << " slip, "
       << in_words(answer.status) << ", " << call.watch.seconds() << " s"
       << endl;
  if (call.verbosity() > 1) report_details(answer);
}

void report_friction(long level, const ContactProblem<2>& problem,
                     const SolvedContact<2>& solved) {
  constexpr double near = 0.01;
  if (level < 1 || mpirank != 0) return;
  const double mu = largest_friction(nodal_law(solved.law, problem.contact));
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
