// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/solid_error.hpp"

#include <array>
#include <memory>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/solid_coulomb.hpp"
#include "ffcontact/sizing/edge_rates.hpp"
//
#include "estimate/estimate_outputs.hpp"
#include "estimate/solid_stress.hpp"
#include "freefem/stopwatch.hpp"
#include "problem/coulomb.hpp"
#include "problem/result_names.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps_in_space = 20;

[[noreturn]] void refuse_of_plane_bodies(const char* parameter) {
  refuse("the contact is that of a mesh3: ", parameter,
         "= is for plane bodies so far");
}

/// What plane bodies have, and a solid has not.
void require_parameters_of_solids(const NamedArguments& named) {
  for (const char* parameter : {"multiplier", "tractions", "construction", "rt",
                                "rabscissa", "corrected", "unmended"})
    if (named.given(parameter)) refuse_of_plane_bodies(parameter);
}

RelaxationSettings relaxation_of(Stack stack, const NamedArguments& named) {
  RelaxationSettings settings;
  settings.tightness = named.number(stack, "tightness", settings.tightness);
  if (!named.given("sweeps") && settings.tightness == 0) return settings;
  const long wanted = named.integer(stack, "sweeps", most_sweeps_in_space);
  if (wanted < 0) refuse("sweeps must not be negative, got ", wanted);
  settings.steps = steps_of_a_sweep * static_cast<int>(wanted);
  return settings;
}

/// rate=, where it is given.
void put_solid_rates(Stack stack, const NamedArguments& named,
                     const Topology<3>& topology,
                     const ContactProblem<3>& problem,
                     const SolvedSolid& solved, const SolvedBody<3>& body) {
  if (!named.given_of_bodies("rate")) return;
  const Flags& prescribed = solved.system->prescribed;
  KnownComponents known =
      given_tractions(topology.mesh, topology.facets, prescribed, body.neumann)
          .known;
  Flags is_contact(topology.facets.count(), 0);
  for (int face : problem.contact.face) {
    known.col(face).setConstant(true);
    is_contact[face] = 1;
  }
  const CellStresses<3> stress =
      total_stresses(topology.mesh, body, body.displacement).mean;
  put_by_bodies(
      stack, named, problem.joined.first_cell, "rate",
      local_rates(topology, singular_lines(topology, body.hooke, stress, known,
                                           is_contact)));
}

void put_tractions(Stack stack, const NamedArguments& named,
                   const Estimate<3>& estimate) {
  constexpr std::array parameter = {"rn", "rt1", "rt2"};
  const auto tractions =
      estimate.face_tractions.reshaped(3, 3 * estimate.face_tractions.cols());
  for (int c = 0; c < 3; ++c)
    named.put(stack, parameter[c], tractions.row(c).transpose());
}

void put(Stack stack, const NamedArguments& named,
         const ContactProblem<3>& problem, const Estimate<3>& estimate) {
  put_by_bodies(stack, named, problem.joined.first_cell, "eps", estimate.local);
  put_error(stack, named, estimate);
  put_tractions(stack, named, estimate);
  put_defects(stack, named, estimate);
}

void report(Stack stack, const NamedArguments& named,
            const Estimate<3>& estimate, double seconds) {
  const long level = named.verbosity_level(stack);
  if (level < 1 || mpirank != 0) return;
  cout << "contacterror: " << estimate.local.size() << " tetrahedra, eps "
       << 100 * estimate.relative << " %, e " << estimate.e << ", "
       << estimate.history.size() - 1 << " steps, " << seconds << " s" << endl;
  report_oscillation(estimate);
  if (level > 1) report_parts(estimate);
}

/// The nodes that slip nowhere, as stick= says.
Flags held_nodes(const ContactSolution<3>& solution, StuckNodes stuck) {
  Flags held(solution.state.size(), 0);
  if (stuck == StuckNodes::stick)
    for (std::size_t i = 0; i < held.size(); ++i)
      held[i] = solution.state[i] == ContactState::stick;
  return held;
}

/// coulomb= and bound=, where one of them is given.
void put_bound(Stack stack, const NamedArguments& named,
               const Topology<3>& topology, const ContactProblem<3>& problem,
               const SolvedSolid& solved, const SolvedBody<3>& body,
               const Estimate<3>& estimate, StuckNodes stuck) {
  if (!named.given("coulomb") && !named.given("bound")) return;
  const SolidCoulomb found =
      solid_coulomb(topology, problem.contact, *solved.system, body, estimate,
                    held_nodes(solved.solution, stuck));
  named.put(stack, "coulomb", found.kappa);
  named.put(stack, "bound", found.bound);
  if (named.verbosity_level(stack) < 1 || mpirank != 0) return;
  cout << "contacterror: mu kappa " << found.friction * found.kappa
       << ", delta " << found.missed << ", bound " << found.bound << ", "
       << stuck_in_words(stuck) << endl;
}

}  // namespace

SolvedBody<3> judged_body(const SolvedSolid& solved) {
  SolvedBody<3> body;
  body.displacement = solved.solution.displacement;
  body.multipliers = solved.solution.force;
  body.law = solved.law;
  body.stiffness = solved.solution.stiffness;
  body.body_loads = solved.holding;
  return body;
}

double solid_error(Stack stack, const NamedArguments& named,
                   SolidContact& contact, const ReadSolids& read,
                   const RelaxFacets<3>& relax) {
  const Stopwatch watch;
  require_parameters_of_solids(named);
  const EstimateSettings<3> settings{relaxation_of(stack, named), {}, relax};
  const StuckNodes stuck = stuck_nodes_of(stack, named);
  if (!contact.solved) refuse_unsolved();
  const ContactProblem<3>& problem = *contact.problem;

  SolvedBody<3> body = judged_body(*contact.solved);
  const Oscillation oscillation = read(problem, body);

  const Topology<3> topology = topology_of(problem.mesh, problem.facets);
  Estimate<3> estimate = estimate_error(
      topology, problem.contact, *contact.solved->system, body, settings);
  put(stack, named, problem, estimate);
  put_solid_stress(stack, named, problem, topology, estimate, body);
  put_solid_rates(stack, named, topology, problem, *contact.solved, body);
  named.put(stack, "oscillation", oscillation.force);
  named.put(stack, "strainoscillation", oscillation.strain);
  report(stack, named, estimate, watch.seconds());
  report_reason(stack, named, estimate);
  put_bound(stack, named, topology, problem, *contact.solved, body, estimate,
            stuck);
  const double relative = estimate.relative;
  contact.solved->estimate =
      std::make_shared<const Estimate<3>>(std::move(estimate));
  contact.solved->judged =
      std::make_shared<const SolvedBody<3>>(std::move(body));
  return relative;
}

}  // namespace ffcontact::plugin
