// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/plane_error.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "ffcontact/base/require.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "estimate/estimate_outputs.hpp"
#include "freefem/progress_lines.hpp"
#include "freefem/stopwatch.hpp"

namespace ffcontact::plugin {

namespace {

/// Sweeps at most when the script asks for a tightness and not for a number of sweeps.
constexpr int most_sweeps = 20;

/// What a solid has, and plane bodies have not.
void require_parameters_of_plane_bodies(const NamedArguments& named) {
  for (const char* parameter : {"rt1", "rt2"})
    if (named.given(parameter))
      refuse(parameter, "= is for a mesh3; plane bodies have rt=");
  for (const char* of_bodies : {"szz", "syz", "sxz"})
    if (named.given_of_bodies(of_bodies)) refuse(of_bodies, "= is for a mesh3");
}

EstimateSettings<2> estimate_settings(Stack stack,
                                      const NamedArguments& named) {
  EstimateSettings<2> settings;
  settings.tractions = named.choice(stack, "tractions", Tractions::free,
                                    {{"free", Tractions::free},
                                     {"fixed", Tractions::fixed},
                                     {"published", Tractions::published}});
  settings.construction =
      named.choice(stack, "construction", Construction::composite,
                   {{"composite", Construction::composite},
                    {"polynomial", Construction::polynomial}});
  RelaxationSettings& relaxation = settings.relaxation;
  relaxation.tightness = named.number(stack, "tightness", relaxation.tightness);
  if (named.given("sweeps") || relaxation.tightness > 0)
    relaxation.steps =
        static_cast<int>(named.integer(stack, "sweeps", most_sweeps));
  settings.report =
      progress_lines("contacterror", named.verbosity_level(stack), 2);
  return settings;
}

void put_rates(Stack stack, const NamedArguments& named,
               const ContactProblem<2>& problem, const ElasticSystem& system,
               const SolvedBody<2>& body) {
  if (!named.given_of_bodies("rate")) return;
  const Topology<2>& topology = problem.topology();
  const BoundaryTractions boundary = boundary_tractions(
      topology.mesh, topology.facets, system.prescribed,
      boundary_moments<2>(topology.mesh, body), problem.contact,
      edge_densities(problem.contact, body.multipliers));
  const std::vector<SingularVertex> singular = singular_vertices(
      topology, body.hooke,
      total_stresses(topology.mesh, body, body.displacement).mean, boundary,
      contact_edge_numbers(problem.contact, topology.facets));
  put_by_bodies(stack, named, problem.joined.first_cell, "rate",
                local_rates(topology, singular));
}

void put_stress(Stack stack, const NamedArguments& named,
                const ContactProblem<2>& problem, const Estimate<2>& estimate) {
  constexpr std::array parameter = {"sxx", "syy", "sxy"};
  const auto wanted = [&](const char* name) {
    return named.given_of_bodies(name);
  };
  if (std::none_of(parameter.begin(), parameter.end(), wanted)) return;
  const std::vector<SubcellStress<2>> stress =
      stress_on_triangles(problem.mesh, estimate);
  for (int c = 0; c < 3; ++c)
    put_by_bodies(stack, named, problem.joined.first_cell, parameter[c],
                  stress_component(stress, c));
}

void put_tractions(Stack stack, const NamedArguments& named,
                   const Estimate<2>& estimate) {
  named.put(stack, "rn", estimate.tractions.normal.reshaped());
  named.put(stack, "rt", estimate.tractions.tangential.reshaped());
  named.put(stack, "corrected", static_cast<long>(estimate.corrected_count()));
  named.put(stack, "unmended", static_cast<long>(estimate.unmended.size()));
}

void put(Stack stack, const NamedArguments& named,
         const ContactProblem<2>& problem, const Estimate<2>& estimate) {
  put_by_bodies(stack, named, problem.joined.first_cell, "eps", estimate.local);
  put_stress(stack, named, problem, estimate);
  put_error(stack, named, estimate);
  named.put(stack, "rabscissa", abscissae(problem, estimate));
  put_tractions(stack, named, estimate);
  put_defects(stack, named, estimate);
}

void report(Stack stack, const NamedArguments& named,
            const ContactProblem<2>& problem, const Estimate<2>& estimate,
            const std::optional<CoulombBound>& bound, double seconds) {
  const long level = named.verbosity_level(stack);
  if (level < 1 || mpirank != 0) return;
  cout << "contacterror: " << problem.mesh.cell_count() << " triangles, eps "
       << 100 * estimate.relative << " %, e " << estimate.e << ", "
       << estimate.corrected_count() << " edges corrected, " << seconds << " s"
       << endl;
  report_oscillation(estimate);
  if (bound)
    cout << "contacterror: mu kappa "
         << bound->constant.friction * bound->constant.kappa << ", bound "
         << bound->value << ", " << stuck_in_words(bound->stuck) << endl;
  if (level > 1) report_parts(estimate);
}

}  // namespace

bool wants_bound(const NamedArguments& named) {
  return named.given("coulomb") || named.given("bound");
}

Estimate<2> plane_error(Stack stack, const NamedArguments& named,
                        const ContactProblem<2>& problem,
                        const JudgedOf& judged_of, const ReadPlane& read) {
  const Stopwatch watch;
  require_parameters_of_plane_bodies(named);
  const EstimateSettings<2> settings = estimate_settings(stack, named);
  const StuckNodes stuck = stuck_nodes_of(stack, named);
  if (problem.law.bonded && settings.tractions == Tractions::published)
    refuse(
        "tractions=\"published\" corrects tractions to a friction cone, which "
        "bonded bodies have not: take \"free\" or \"fixed\"");
  Judged judged = judged_of();
  const Oscillation oscillation = read(problem, judged.body);
  const ElasticSystem& system = *judged.system;
  Estimate<2> estimate = estimate_error(problem.topology(), problem.contact,
                                        system, judged.body, settings);
  put(stack, named, problem, estimate);
  put_rates(stack, named, problem, system, judged.body);
  named.put(stack, "oscillation", oscillation.force);
  named.put(stack, "strainoscillation", oscillation.strain);
  const double seconds = watch.seconds();
  std::optional<CoulombBound> bound;
  if (wants_bound(named)) {
    bound = coulomb_bound_of(problem.contact, judged, estimate, stuck);
    named.put(stack, "coulomb", bound->constant.kappa);
    named.put(stack, "bound", bound->value);
  }
  report(stack, named, problem, estimate, bound, seconds);
  report_reason(stack, named, estimate);
  return estimate;
}

}  // namespace ffcontact::plugin
