// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/estimate/bodies/compared.hpp"
#include "ffcontact/estimate/checks/law_of_matrix.hpp"
#include "ffcontact/estimate/checks/reason_against.hpp"
#include "ffcontact/estimate/checks/sound_problem.hpp"
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"
#include "ffcontact/estimate/error/contact_edges.hpp"
#include "ffcontact/estimate/error/error_history.hpp"
#include "ffcontact/estimate/error/polynomial_norms.hpp"
#include "ffcontact/estimate/error/spring_parts.hpp"
#include "ffcontact/estimate/error/wide_cones.hpp"
#include "ffcontact/estimate/tractions/first_tractions.hpp"
#include "ffcontact/estimate/tractions/tool_work.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// sigma_hat, by its moments on the edges, and r_hat.
struct RelaxedTractions {
  EdgeMoments moments;
  ContactDensities contact;
  std::vector<double> falls;  ///< of e^2, sweep by sweep
};

RelaxedTractions relaxed(MatchedBodies& bodies, const Compared& compared,
                         FirstTractions first, const EstimateSettings& settings,
                         const VectorXd& u_hat, bool contact_is_free) {
  const auto& [mesh, edges, ridges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  const SolvedBody<2>& body = bodies.body();
  const ContactDensities& densities = first.contact.densities;
  const BoundaryTractions boundary = bodies.boundary_with(densities);
  const std::vector<FreeSpring<2>> springs = free_springs<2>(
      mesh, edges, body.springs, boundary, u_hat, bodies.spring_tractions());
  const BoundaryTractions without_springs = released<2>(boundary, springs);

  FacetSetting<2> setting{{bodies.topology(), body.hooke, without_springs,
                           compared.body_loads(body), compared.stress,
                           terms_of<2>(springs)}};
  if (contact_is_free)
    setting.contact = contact_edges(line, compared.law, compared.displacement,
                                    densities, boundary);
  setting.kept_work = tool_work(mesh, line, body).fields;
  setting.report = settings.report;
  RelaxedTractions result{std::move(first.moments), densities, {}};
  result.falls = relax_facets<2>(setting, settings.relaxation, result.moments);
  put_tractions(setting.contact, result.moments, result.contact);
  if (settings.tractions != Tractions::published)
    clamp_rounding(line, body.law, result.contact);
  add_spring_changes<2>(mesh, edges, springs, boundary, result.moments,
                        bodies.spring_tractions());
  put_known<2>(bodies.boundary_with(result.contact), result.moments);
  return result;
}

/// Adds the contact part of each edge to its triangle, or half of it to each of the two
/// that face each other there.
void share_contact_part(const Edges& edges, const ContactLine& line,
                        const VectorXd& contact_part, VectorXd& local) {
  for (int e = 0; e < line.edge_count(); ++e) {
    const int facing = facing_edge(line, e);
    local[edges.cells(0, line.edge[e])] +=
        (facing < 0 ? 1 : 0.5) * contact_part[e];
    if (facing >= 0) local[edges.cells(0, facing)] += 0.5 * contact_part[e];
  }
}

StressNorms<2> norms_by(Construction construction, const MatchedBodies& bodies,
                        const Compared& compared,
                        const RelaxedTractions& relaxed, Estimate& estimate) {
  const SolvedBody<2>& body = bodies.body();
  const BoundaryTractions boundary = bodies.boundary_with(relaxed.contact);
  const LoadedFacets<2> difference{bodies.topology(), body.hooke, boundary,
                                   compared.body_loads(body), compared.stress};
  return stress_norms<2>({difference, relaxed.moments, body.body_loads},
                         construction == Construction::composite
                             ? composite_norms<2>
                             : polynomial_norms,
                         &estimate.stress);
}

/// (2.11) to (2.13).
void put_error(const MatchedBodies& bodies, const StressNorms<2>& norms,
               const SpringNorms& springs, const VectorXd& contact_part,
               Estimate& estimate) {
  const double elastic = norms.difference.sum(), sum = norms.sum + springs.sum,
               scale = sum > 0 ? sum : 1;
  estimate.elastic = std::sqrt(elastic);
  estimate.e =
      std::sqrt(square_of_error(elastic + estimate.springs, estimate.contact));
  estimate.relative = estimate.e / std::sqrt(scale);
  VectorXd local = norms.difference;
  share_contact_part(bodies.topology().facets, bodies.line(), contact_part,
                     local);
  add_spring_parts<2>(bodies.topology().facets, springs.difference, local);
  estimate.local =
      (bodies.sums_of_parts(local) / scale).cwiseMax(0.0).cwiseSqrt();
}

/// e and its parts, and sigma_hat.
StressNorms<2> put_error(const MatchedBodies& bodies, const Compared& compared,
                         const RelaxedTractions& relaxed,
                         Construction construction, Estimate& estimate) {
  const VectorXd contact_part = contact_error(
      bodies.line(), compared.law, relaxed.contact, compared.displacement);
  estimate.contact = contact_part.sum();
  const SpringNorms springs =
      spring_norms<2>(bodies.topology().mesh, bodies.body().springs,
                      estimate.displacement, bodies.spring_tractions());
  estimate.springs = springs.difference.sum();
  StressNorms<2> norms =
      norms_by(Construction::composite, bodies, compared, relaxed, estimate);
  estimate.history =
      error_history(square_of_error(norms.difference.sum() + estimate.springs,
                                    estimate.contact),
                    relaxed.falls);
  if (construction != Construction::composite)
    norms = norms_by(construction, bodies, compared, relaxed, estimate);
  put_error(bodies, norms, springs, contact_part, estimate);
  return norms;
}

/// Contact tractions beside the largest stress: makes what is relative to the former
/// relative to the latter, where an open contact line carries nothing but rounding.
double share_of_contact(const ContactDensities& densities,
                        const LinearStresses<2>& stress) {
  const double contact = largest_traction(densities);
  return relative(contact, std::max(contact, max_norm(stress.mean)));
}

/// What equilibrium is judged against at least [MPa].
double stress_scale(const MatchedBodies& bodies, const Compared& compared,
                    double largest, const Estimate& estimate) {
  return std::max(
      {max_norm(compared.stress.mean), largest,
       least_part_of_terms * largest_stress_terms(bodies.topology(),
                                                  bodies.line(), bodies.body(),
                                                  estimate.displacement)});
}

/// Beside the largest stress; what tractions miss of the work along a tool counts as missing
/// on the boundary.
EquilibriumDefect relative_defect(const MatchedBodies& bodies,
                                  EquilibriumDefect defect, double scale,
                                  const ContactDensities& tractions) {
  const ToolWork work =
      tool_work(bodies.topology().mesh, bodies.line(), bodies.body());
  defect.boundary =
      std::max(defect.boundary, tool_defect(bodies.line(), work, tractions));
  return defect.relative_to(scale > 0 ? scale : 1);
}

std::string reason_of(const MatchedBodies& bodies, int deepest_node,
                      const BetweenNodes& found, Construction construction,
                      const Estimate& estimate) {
  const auto& [mesh, edges, ridges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  return reason_against(
      estimate,
      {mesh.place(line.vertex[deepest_node]),
       middle_of(mesh, edges, line.edge[found.turned_facet]),
       middle_of(mesh, edges, line.edge[found.negative_facet])},
      construction, estimate.unmended.size());
}

/// What the theory promises, measured.
void judge(const MatchedBodies& bodies, const Compared& compared,
           const StressNorms<2>& norms, Construction construction,
           Estimate& estimate) {
  const ContactLine& line = bodies.line();
  const SolvedBody<2>& body = bodies.body();
  const VectorXd& u_hat = estimate.displacement;
  const double scale = stress_scale(bodies, compared, norms.largest, estimate),
               moved = max_norm(body.displacement);
  estimate.equilibrium =
      relative_defect(bodies, norms.defect, scale, estimate.tractions);
  estimate.cone = cone_defect(line, body.law, estimate.tractions) *
                  share_of_contact(estimate.tractions, compared.stress);
  const PenetrationDefect penetration =
      penetration_defect(line, body.law, u_hat, moved);
  estimate.penetration = penetration.value;
  const BetweenNodes found =
      between_nodes(line, body.law, estimate.tractions, u_hat);
  put_between_nodes(found,
                    std::max(scale, largest_traction(estimate.tractions)) *
                        std::max(moved, largest_displacement(body.law, u_hat)),
                    estimate);
  estimate.reason =
      reason_of(bodies, penetration.node, found, construction, estimate);
  estimate.admissible = estimate.reason.empty();
}

/// Steps 1 to 6 of the estimate.
Estimate estimate_of(const SolvedProblem<2>& solved, const StressTerms& terms,
                     const EstimateSettings& settings) {
  tell(settings.report, {"admissible fields", 0, "dofs",
                         static_cast<double>(solved.system.dof_count())});
  // Facing traces that match, by cutting where they do not.
  MatchedBodies bodies(solved);
  Estimate estimate;

  // 1. Admissible displacement [CHH01, 4.1].
  estimate.displacement = sticking_displacement(
      bodies, nodal_pressures(solved),
      admissible_displacement(bodies.line(), bodies.body().law,
                              bodies.body().displacement, bodies.prescribed()));
  const Compared u_hat =
      terms.unstressed
          ? compared_change(bodies, terms.stress, estimate.displacement)
          : compared(bodies, estimate.displacement);

  // 2., 3. Contact tractions in the cone, edge tractions in equilibrium with them.
  FirstTractions first = first_tractions(
      solved, bodies, terms, settings.tractions, estimate.displacement);
  estimate.shift = first.contact.shift;
  estimate.unmended = first.contact.unmended;

  // 4. Star relaxation of sigma_hat - C eps(u_hat), and of r_hat in the cone.
  RelaxedTractions tractions =
      relaxed(bodies, u_hat, std::move(first), settings, estimate.displacement,
              settings.tractions == Tractions::free && !terms.unstressed);

  // 5. The error and its parts [CHH01, (2.11)-(2.13)].
  const StressNorms<2> norms =
      put_error(bodies, u_hat, tractions, settings.construction, estimate);
  estimate.tractions = std::move(tractions.contact);
  estimate.spring_tractions = bodies.spring_tractions();
  if (terms.unstressed)  // to the last digit: above it is what u_hat - u leaves
    for (SubcellStress<2>& zero : estimate.stress) zero.setZero();

  // 6. What the theory promises, measured.
  judge(bodies, u_hat, norms, settings.construction, estimate);
  estimate.refinement = bodies.take_refinement();
  return estimate;
}

}  // namespace

int Estimate::corrected_count() const {
  return static_cast<int>((shift.array() != 0).count());
}

Estimate estimate_error(const Topology<2>& topology, const ContactLine& line,
                        const ElasticSystem& system, const SolvedBody<2>& body,
                        const EstimateSettings& settings) {
  const SolvedProblem<2> solved{topology, line, system, body};
  require_sound(solved, settings.relaxation);
  require_law_of_matrix<2>(topology.mesh, system, body.hooke, body.springs);
  const double stress_terms =
      largest_stress_terms(topology, line, body, body.displacement);
  if (!is_unstressed(topology, line, system.prescribed, body, stress_terms))
    return estimate_of(solved, {stress_terms, false}, settings);
  SolvedBody<2> unstressed = body;
  unstressed.multipliers.setZero();
  return estimate_of({topology, line, system, unstressed}, {stress_terms, true},
                     settings);
}

}  // namespace ffcontact
