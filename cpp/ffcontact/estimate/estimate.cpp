// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/parted_sum.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/gaps_in_reach.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/estimate/bodies/unturned_body.hpp"
#include "ffcontact/estimate/checks/law_of_matrix.hpp"
#include "ffcontact/estimate/checks/sound_problem.hpp"
#include "ffcontact/estimate/contact_steps.hpp"
#include "ffcontact/estimate/error/error_history.hpp"
#include "ffcontact/estimate/error/polynomial_norms.hpp"
#include "ffcontact/estimate/error/spring_parts.hpp"
#include "ffcontact/estimate/tractions/tool_work.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// May r_hat be relaxed?
template <int d>
bool contact_is_free(const EstimateSettings<d>& settings,
                     const StressTerms& terms) {
  if constexpr (d == 2)
    if (settings.tractions != Tractions::free) return false;
  return !terms.unstressed;
}

/// The boundary tractions that stay as they are.
template <int d>
FacetTractions<d> without_free_springs(
    const FacetTractions<d>& boundary,
    const std::vector<FreeSpring<d>>& springs) {
  return springs.empty() ? FacetTractions<d>() : released<d>(boundary, springs);
}

template <int d>
RelaxedTractions<d> relaxed(MatchedBodies<d>& bodies,
                            const Compared<d>& compared,
                            FirstTractions<d> first,
                            const EstimateSettings<d>& settings,
                            const VectorXd& u_hat, bool contact_is_free) {
  const auto& [mesh, facets, ridges, stars] = bodies.topology();
  const SolvedBody<d>& body = bodies.body();
  RelaxedTractions<d> result{std::move(first.contact),
                             std::move(first.moments)};
  const FacetTractions<d> boundary =
      bodies.boundary_with(result.contact.densities);
  const std::vector<FreeSpring<d>> springs = free_springs<d>(
      mesh, facets, body.springs, boundary, u_hat, bodies.spring_tractions());
  const FacetTractions<d> without = without_free_springs(boundary, springs);

  result.facets = contact_facets(bodies, compared, result.contact, boundary);
  std::vector<FacetTerm<d>> terms = terms_of<d>(springs);
  for (const FacetTerm<d>& term : layer_terms<d>(bodies.contact(), body.law,
                                                 result.facets, result.moments))
    terms.push_back(term);
  FacetSetting<d> setting{
      {bodies.topology(), body.hooke, springs.empty() ? boundary : without,
       compared.body_loads(body), compared.stress, std::move(terms)}};
  if (contact_is_free) {
    setting.contact = result.facets;
    setting.oscillation =
        facing_oscillations(bodies, result.facets, result.contact);
  }
  if constexpr (d == 2)
    setting.kept_work = tool_work(mesh, bodies.contact(), body).fields;
  setting.report = settings.report;
  result.falls = settings.relax(setting, settings.relaxation, result.moments);
  add_spring_changes<d>(mesh, facets, springs, boundary, result.moments,
                        bodies.spring_tractions());
  put_relaxed(bodies, settings, setting.contact, result);
  return result;
}

/// sigma_hat and its norms; it is kept for plane bodies, whose constructions differ.
template <int d>
StressNorms<d> norms_by(NormsOfCell<d> norms, const MatchedBodies<d>& bodies,
                        const Compared<d>& compared,
                        const RelaxedTractions<d>& tractions,
                        Estimate<d>& estimate) {
  const SolvedBody<d>& body = bodies.body();
  const LoadedFacets<d> difference{bodies.topology(), body.hooke,
                                   tractions.boundary,
                                   compared.body_loads(body), compared.stress};
  std::vector<SubcellStress<d>>* stress = nullptr;
  if constexpr (d == 2) stress = &estimate.stress;
  return stress_norms<d>({difference, tractions.moments, body.body_loads},
                         norms, stress);
}

double sum_of(const VectorXd& squares) {
  return parted_sum(static_cast<int>(squares.size()),
                    [&](int t) { return squares[t]; });
}

/// (2.11) to (2.13).
template <int d>
void put_error(const MatchedBodies<d>& bodies, const StressNorms<d>& norms,
               const SpringNorms& springs, const VectorXd& contact_part,
               double sum_of_layer, Estimate<d>& estimate) {
  const double elastic = sum_of(norms.difference),
               sum = norms.sum + springs.sum + sum_of_layer,
               scale = sum > 0 ? sum : 1;
  estimate.elastic = std::sqrt(elastic);
  estimate.e =
      std::sqrt(square_of_error(elastic + estimate.springs, estimate.contact));
  estimate.relative = estimate.e / std::sqrt(scale);
  VectorXd local = norms.difference;
  add_contact_part(bodies, contact_part, local);
  add_spring_parts<d>(bodies.topology().facets, springs.difference, local);
  estimate.local = (bodies.sums_of_parts(std::move(local)) / scale)
                       .cwiseMax(0.0)
                       .cwiseSqrt();
}

/// e and its parts, and sigma_hat.
template <int d>
StressNorms<d> put_error(const MatchedBodies<d>& bodies,
                         const Compared<d>& compared,
                         const RelaxedTractions<d>& tractions,
                         const EstimateSettings<d>& settings,
                         Estimate<d>& estimate) {
  VectorXd contact_part = contact_part_of(bodies, compared, tractions);
  const SpringNorms layer = layer_norms_of(bodies, tractions);
  if (layer.difference.size() > 0) contact_part += layer.difference;
  estimate.contact = contact_part.sum();
  const SpringNorms springs =
      spring_norms<d>(bodies.topology().mesh, bodies.body().springs,
                      estimate.displacement, bodies.spring_tractions());
  estimate.springs = springs.difference.sum();
  StressNorms<d> norms =
      norms_by(composite_norms<d>, bodies, compared, tractions, estimate);
  estimate.history =
      error_history(square_of_error(sum_of(norms.difference) + estimate.springs,
                                    estimate.contact),
                    tractions.falls);
  if constexpr (d == 2)
    if (settings.construction == Construction::polynomial)
      norms = norms_by(polynomial_norms, bodies, compared, tractions, estimate);
  put_error(bodies, norms, springs, contact_part, layer.sum, estimate);
  return norms;
}

/// What equilibrium is judged against [MPa].
template <int d>
double stress_scale(const MatchedBodies<d>& bodies, const Compared<d>& compared,
                    const StressNorms<d>& norms, const VectorXd& u_hat) {
  return std::max(
      {max_norm(compared.stress.mean), norms.largest,
       least_part_of_terms * largest_stress_terms<d>(bodies.topology(),
                                                     bodies.contact(),
                                                     bodies.body(), u_hat)});
}

/// What tractions miss of the work along a tool counts as missing on the boundary.
template <int d>
EquilibriumDefect with_tool(const MatchedBodies<d>& bodies,
                            const ContactTractions<d>& contact,
                            EquilibriumDefect defect) {
  if constexpr (d == 2) {
    const ContactLine& line = bodies.contact();
    const ToolWork work =
        tool_work(bodies.topology().mesh, line, bodies.body());
    defect.boundary =
        std::max(defect.boundary, tool_defect(line, work, contact.densities));
  }
  return defect;
}

template <int d>
WorstPlaces places_of(const MatchedBodies<d>& bodies, int deepest_node,
                      const BetweenNodes& found) {
  const auto& [mesh, facets, ridges, stars] = bodies.topology();
  const auto& contact = bodies.contact();
  const VectorXi& of_contact = facets_of(contact);
  return {mesh.place(contact.vertex[deepest_node]),
          bodies.body().law.is_bonded(deepest_node),
          middle_of(mesh, facets, of_contact[found.turned_facet]),
          middle_of(mesh, facets, of_contact[found.negative_facet])};
}

/// What the theory promises, measured.
template <int d>
void judge(const MatchedBodies<d>& bodies, const Compared<d>& compared,
           const RelaxedTractions<d>& tractions, const StressNorms<d>& norms,
           const EstimateSettings<d>& settings, Estimate<d>& estimate) {
  const SolvedBody<d>& body = bodies.body();
  const VectorXd& u_hat = estimate.displacement;
  const double scale = stress_scale(bodies, compared, norms, u_hat),
               largest = largest_traction(tractions.contact),
               moved = std::max(max_norm(body.displacement),
                                largest_displacement(body.law, u_hat));
  estimate.equilibrium = with_tool(bodies, tractions.contact, norms.defect)
                             .relative_to(scale > 0 ? scale : 1);
  // an open contact carries nothing but rounding: beside the largest stress
  estimate.cone = relative(cone_violation(bodies, tractions),
                           std::max(largest, max_norm(compared.stress.mean)));
  const DeepestNode deepest = deepest_node(bodies, u_hat);
  estimate.penetration = relative(deepest.depth, moved);
  const BetweenNodes found = between_nodes(bodies, tractions.contact, u_hat);
  put_between_nodes(found, std::max(scale, largest) * moved, estimate);
  estimate.reason =
      reason_of(bodies, tractions, places_of(bodies, deepest.node, found),
                settings, estimate);
  estimate.admissible = estimate.reason.empty();
}

/// Each time that loads hold what slides r_hat feels a thousandth of them at most.
constexpr int most_holdings = 8;

template <int d>
Estimate<d> estimate_of(const SolvedProblem<d>& solved,
                        const StressTerms& terms,
                        const EstimateSettings<d>& settings,
                        int holdings = most_holdings);

/// With further loads of the cells, which hold what slides.
template <int d>
Estimate<d> estimate_with(const BodyLoadsOfCells<d>& loads,
                          const SolvedProblem<d>& solved,
                          const StressTerms& terms,
                          const EstimateSettings<d>& settings, int holdings) {
  if (holdings == 0)
    refuse(
        "a motion that slides along all of the contact is not held: hold the "
        "body by a weak spring=");
  const auto& [topology, contact, system, body] = solved;
  SolvedBody<d> loaded = body;
  loaded.body_loads += loads;
  Estimate<d> estimate = estimate_of<d>({topology, contact, system, loaded},
                                        terms, settings, holdings - 1);
  if constexpr (d == 3)
    if (estimate.body_loads.cols() == 0)
      estimate.body_loads = std::move(loaded.body_loads);
  return estimate;
}

/// Steps 1 to 6 of the estimate.
template <int d>
Estimate<d> estimate_of(const SolvedProblem<d>& solved,
                        const StressTerms& terms,
                        const EstimateSettings<d>& settings, int holdings) {
  tell(settings.report, {"admissible fields", 0, "dofs",
                         static_cast<double>(solved.system.dof_count())});
  // Facing traces that match, by cutting where they do not.
  MatchedBodies<d> bodies(solved);
  Estimate<d> estimate;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = displacement_of_pair(solved, bodies);
  const Compared<d> u_hat = compared(bodies, terms, estimate.displacement);

  // 2., 3. Contact tractions in the cone, facet tractions in equilibrium with them.
  FirstTractions<d> first =
      first_tractions(solved, bodies, terms, settings, estimate.displacement);
  if (first.holding.cols() > 0)
    return estimate_with(first.holding, solved, terms, settings, holdings);

  // 4. Relaxation of sigma_hat - C eps(u_hat), and of r_hat in the cone.
  RelaxedTractions<d> tractions =
      relaxed(bodies, u_hat, std::move(first), settings, estimate.displacement,
              contact_is_free(settings, terms));

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  const StressNorms<d> norms =
      put_error(bodies, u_hat, tractions, settings, estimate);
  if constexpr (d == 2)
    if (terms
            .unstressed)  // to the last digit: above it is what u_hat - u leaves
      for (SubcellStress<2>& zero : estimate.stress) zero.setZero();

  // 6. What the theory promises, measured.
  judge(bodies, u_hat, tractions, norms, settings, estimate);
  put_fields(bodies, std::move(tractions), estimate);
  return estimate;
}

/// The estimate, where what is bonded is on a line that does not turn.
template <int d>
Estimate<d> straightened(const SolvedProblem<d>& solved,
                         const StressTerms& terms,
                         const EstimateSettings<d>& settings) {
  const auto& [topology, contact, system, body] = solved;
  if constexpr (d == 2)
    if (bonded_part_turns(contact, body.law.bonded)) {
      const UnturnedLine unturned = unturned_line(
          topology.mesh, topology.facets, contact, body.law.bonded);
      const SolvedBody<2> on_it = unturned_body(solved, unturned);
      return estimate_of<2>({topology, unturned.line, system, on_it}, terms,
                            settings);
    }
  return estimate_of(solved, terms, settings);
}

}  // namespace

template <int d>
Estimate<d> estimate_error(const Topology<d>& topology,
                           const LineOrSurface<d>& contact,
                           const ElasticSystem& system,
                           const SolvedBody<d>& body,
                           const EstimateSettings<d>& settings) {
  const SolvedProblem<d> solved{topology, contact, system, body};
  require_sound(solved, settings.relaxation);
  const auto with_law = [&](const ContactLaw<d>& law) {
    SolvedBody<d> same = body;
    same.law = law;
    return estimate_error<d>(topology, contact, system, same, settings);
  };
  // Rounding of r_n would cost as much as it is times a gap that never closes.
  if (const double moved = max_norm(body.displacement);
      has_far_gaps(body.law, moved))
    return with_law(with_gaps_in_reach(body.law, moved));
  if (body.law.layer.given() && body.law.carried.size() == 0)
    return with_law(on_layer(body.law, carried_tractions(solved)));
  require_law_of_matrix<d>(topology.mesh, system, body.hooke, body.springs);
  const StressTerms terms = stress_terms_of(solved);
  if (!terms.unstressed) return straightened(solved, terms, settings);
  SolvedBody<d> unstressed = body;
  unstressed.multipliers.setZero();
  return straightened<d>({topology, contact, system, unstressed}, terms,
                         settings);
}

template Estimate<FFCONTACT_DIMENSION> estimate_error(
    const Topology<FFCONTACT_DIMENSION>&,
    const LineOrSurface<FFCONTACT_DIMENSION>&, const ElasticSystem&,
    const SolvedBody<FFCONTACT_DIMENSION>&,
    const EstimateSettings<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
