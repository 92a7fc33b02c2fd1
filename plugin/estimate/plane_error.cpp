// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "ffcontact/estimate/stress_on_triangles.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/sizing/local_rates.hpp"
//
#include "estimate/contact_error_of.hpp"
#include "freefem/progress_lines.hpp"

namespace ffcontact::plugin {

namespace {

void require_parameters_of_plane_bodies(const NamedArguments& named) {
  for (const char* parameter : {"rt1", "rt2"})
    if (named.given(parameter))
      refuse(parameter, "= is for a mesh3; plane bodies have rt=");
  for (const char* of_bodies : {"szz", "syz", "sxz"})
    if (named.given_of_bodies(of_bodies)) refuse(of_bodies, "= is for a mesh3");
}

void put_rates(Stack stack, const NamedArguments& named,
               const ContactProblem<2>& problem, const Topology<2>& topology,
               const Judged<2>& judged) {
  if (!named.given_of_bodies("rate")) return;
  const SolvedBody<2>& body = judged.body;
  const BoundaryTractions boundary = boundary_tractions(
      topology.mesh, topology.facets, judged.system->prescribed,
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
                   const ContactProblem<2>& problem,
                   const Estimate<2>& estimate) {
  named.put(stack, "rabscissa", abscissae(problem, estimate));
  named.put(stack, "rn", estimate.tractions.normal.reshaped());
  named.put(stack, "rt", estimate.tractions.tangential.reshaped());
  named.put(stack, "corrected", static_cast<long>(estimate.corrected_count()));
  named.put(stack, "unmended", static_cast<long>(estimate.unmended.size()));
}

}  // namespace

template <>
EstimateSettings<2> ErrorOf<2>::settings(Stack stack,
                                         const NamedArguments& named,
                                         const ContactLaw<2>& law) {
  require_parameters_of_plane_bodies(named);
  EstimateSettings<2> settings;
  settings.tractions = named.choice(stack, "tractions", Tractions::free,
                                    {{"free", Tractions::free},
                                     {"fixed", Tractions::fixed},
                                     {"published", Tractions::published}});
  settings.construction =
      named.choice(stack, "construction", Construction::composite,
                   {{"composite", Construction::composite},
                    {"polynomial", Construction::polynomial}});
  settings.report =
      progress_lines("contacterror", named.verbosity_level(stack), 2);
  if (law.has_bonded() && settings.tractions == Tractions::published)
    refuse(
        "tractions=\"published\" corrects tractions to a friction cone, which "
        "bonded bodies have not: take \"free\" or \"fixed\"");
  return settings;
}

template <>
void ErrorOf<2>::put(Stack stack, const NamedArguments& named,
                     const ContactProblem<2>& problem,
                     const Topology<2>& topology, const Judged<2>& judged,
                     const Estimate<2>& estimate) {
  put_stress(stack, named, problem, estimate);
  put_tractions(stack, named, problem, estimate);
  put_rates(stack, named, problem, topology, judged);
}

template <>
CoulombBound ErrorOf<2>::bound(const ContactProblem<2>& problem,
                               const Topology<2>&, const Judged<2>& judged,
                               const Estimate<2>& estimate, StuckNodes stuck) {
  const CoulombConstant constant =
      coulomb_constant_of(problem.contact, judged, stuck);
  const double e = estimate.e + estimate.oscillation;
  return {constant, 0,
          estimate.admissible
              ? coulomb_bound(e, constant.friction, constant.kappa)
              : infinity};
}

template <>
void ErrorOf<2>::report(const Estimate<2>& estimate, double seconds) {
  cout << "contacterror: " << estimate.local.size() << " triangles, eps "
       << 100 * estimate.relative << " %, e " << estimate.e << ", "
       << estimate.corrected_count() << " edges corrected, " << seconds << " s"
       << endl;
}

template JudgedError<2> contact_error(Stack, const NamedArguments&,
                                      const ContactProblem<2>&,
                                      const JudgedOf<2>&, const ReadBodies<2>&,
                                      const RelaxFacets<2>&);

}  // namespace ffcontact::plugin
