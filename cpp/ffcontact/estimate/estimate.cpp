// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/estimate.hpp"

#include <cmath>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/equilibrium/tractions/difference_loads.hpp"
#include "ffcontact/equilibrium/tractions/free_springs.hpp"
#include "ffcontact/estimate/bodies/compared.hpp"
#include "ffcontact/estimate/checks/law_of_matrix.hpp"
#include "ffcontact/estimate/checks/reason_against.hpp"
#include "ffcontact/estimate/checks/sound_problem.hpp"
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"
#include "ffcontact/estimate/error/error_history.hpp"
#include "ffcontact/estimate/error/stress_norms.hpp"
#include "ffcontact/estimate/error/wide_cones.hpp"
#include "ffcontact/estimate/tractions/first_tractions.hpp"
#include "ffcontact/estimate/tractions/tool_work.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

double largest_value(const std::vector<CompositeStress>& stress) {
  double largest = 0;
  for (const CompositeStress& values : stress)
    largest = std::max(largest, max_norm(values));
  return largest;
}

/// sigma_hat, by its moments on the edges, and r_hat.
struct RelaxedTractions {
  EdgeMoments moments;
  ContactDensities contact;
  std::vector<double> falls;  ///< of e^2, sweep by sweep
};

/// Beside the largest stress: admissible pairs are in equilibrium to 1e-10 of it.
constexpr double rounding_of_traction = 1e-11;

FreeTractions free_tractions(const ContactLine& line, const Compared& compared,
                             const ContactDensities& densities,
                             std::vector<int> contact_edge) {
  const TractionCosts costs =
      traction_costs(line, compared.law, densities, compared.displacement);
  for (int& e : contact_edge)
    if (e >= 0 && stays_unloaded(line, compared, densities, costs, e)) e = -1;
  const double largest =
      std::max(largest_traction(densities), max_norm(compared.stress.mean));
  return {densities, costs.normal, costs.tangential, std::move(contact_edge),
          rounding_of_traction * largest};
}

RelaxedTractions relaxed(MatchedBodies& bodies, const Compared& compared,
                         FirstTractions first, const EstimateSettings& settings,
                         const VectorXd& u_hat, bool contact_is_free) {
  const auto& [mesh, edges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  const SolvedBody& body = bodies.body();
  const ContactDensities& densities = first.contact.densities;
  const BoundaryTractions boundary = bodies.boundary_with(densities);
  const std::vector<int> contact_edge = contact_edge_numbers(line, edges);
  const std::vector<FreeSpring> springs =
      free_springs(mesh, edges, body.springs, boundary, contact_edge, u_hat,
                   bodies.spring_tractions());
  const BoundaryTractions without_springs = released(boundary, springs);

  RelaxedTractions result{std::move(first.moments), {}, {}};
  FreeTractions tractions =
      free_tractions(line, compared, densities, contact_edge);
  FreeContact contact{line, body.law, tractions,
                      tool_work(mesh, line, body).fields};
  const Ridges<2> ridges = ridges_of(mesh, edges);
  const BodyLoadsOfAll body_loads = compared.body_loads(body);
  result.falls = relax_stars({{mesh, edges, ridges},
                              body.hooke,
                              without_springs,
                              body_loads,
                              compared.stress.mean,
                              compared.stress.variation,
                              terms_of(springs)},
                             settings.relaxation, result.moments,
                             contact_is_free ? &contact : nullptr);
  result.contact = std::move(tractions.densities);
  if (settings.tractions != Tractions::published)
    clamp_rounding(line, body.law, result.contact);
  add_spring_changes(mesh, edges, springs, boundary, result.moments,
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

/// Adds the springs' part of each edge to its triangle.
void share_spring_part(const Edges& edges, const VectorXd& of_column,
                       VectorXd& local) {
  if (of_column.size() == 0) return;
  for (int e = 0; e < edges.count(); ++e)
    if (edges.on_boundary(e))
      local[edges.cells(0, e)] += of_column[edges.boundary_index[e]];
}

StressNorms norms_by(Construction construction, const MatchedBodies& bodies,
                     const Compared& compared,
                     const RelaxedTractions& relaxed) {
  const auto& norms = construction == Construction::composite
                          ? composite_norms
                          : polynomial_norms;
  const SolvedBody& body = bodies.body();
  const auto& [mesh, edges, stars] = bodies.topology();
  return norms(mesh, body.hooke, compared.stress,
               difference_loads(mesh, edges, relaxed.moments, compared.stress),
               compared.body_loads(body));
}

/// (2.11) to (2.13).
void put_error(const MatchedBodies& bodies, const StressNorms& norms,
               const SpringNorms& springs, const VectorXd& contact_part,
               Estimate& estimate) {
  const double elastic = norms.difference.sum(), sum = norms.sum + springs.sum,
               scale = sum > 0 ? sum : 1;
  estimate.elastic = std::sqrt(elastic);
  estimate.e =
      std::sqrt(square_of_error(elastic + estimate.springs, estimate.contact));
  estimate.relative = estimate.e / std::sqrt(scale);
  VectorXd local = norms.difference;
  share_contact_part(bodies.topology().edges, bodies.line(), contact_part,
                     local);
  share_spring_part(bodies.topology().edges, springs.difference, local);
  estimate.local =
      (bodies.sums_of_parts(local) / scale).cwiseMax(0.0).cwiseSqrt();
}

/// e and its parts, and sigma_hat.
void put_error(const MatchedBodies& bodies, const Compared& compared,
               const RelaxedTractions& relaxed, Construction construction,
               Estimate& estimate) {
  const VectorXd contact_part = contact_error(
      bodies.line(), compared.law, relaxed.contact, compared.displacement);
  estimate.contact = contact_part.sum();
  const SpringNorms springs =
      spring_norms(bodies.topology().mesh, bodies.body().springs,
                   estimate.displacement, bodies.spring_tractions());
  estimate.springs = springs.difference.sum();
  StressNorms norms =
      norms_by(Construction::composite, bodies, compared, relaxed);
  estimate.history =
      error_history(square_of_error(norms.difference.sum() + estimate.springs,
                                    estimate.contact),
                    relaxed.falls);
  if (construction != Construction::composite)
    norms = norms_by(construction, bodies, compared, relaxed);
  put_error(bodies, norms, springs, contact_part, estimate);
  estimate.stress = std::move(norms.stress);
}

/// Contact tractions beside the largest stress: makes what is relative to the former
/// relative to the latter, where an open contact line carries nothing but rounding.
double share_of_contact(const ContactDensities& densities,
                        const LinearStresses& stress) {
  const double contact = largest_traction(densities);
  return relative(contact, std::max(contact, max_norm(stress.mean)));
}

/// What equilibrium is judged against at least [MPa].
double stress_scale(const MatchedBodies& bodies, const Compared& compared,
                    const Estimate& estimate) {
  const double terms = largest_stress_terms(
      bodies.topology(), bodies.line(), bodies.body(), estimate.displacement);
  return std::max({max_norm(compared.stress.mean),
                   largest_value(estimate.stress),
                   least_part_of_terms * terms});
}

/// What the theory promises, measured.
void judge(const MatchedBodies& bodies, const Compared& compared,
           Construction construction, Estimate& estimate) {
  const auto& [mesh, edges, stars] = bodies.topology();
  const ContactLine& line = bodies.line();
  const SolvedBody& body = bodies.body();
  const VectorXd& u_hat = estimate.displacement;
  const double scale = stress_scale(bodies, compared, estimate);
  estimate.equilibrium =
      equilibrium_defect(mesh, edges, estimate.stress, body.body_loads,
                         bodies.boundary_with(estimate.tractions), scale);
  const double of_tool =
      tool_defect(line, tool_work(mesh, line, body), estimate.tractions);
  if (of_tool > 0)
    estimate.equilibrium.boundary =
        std::max(estimate.equilibrium.boundary, of_tool / scale);
  estimate.cone = cone_defect(line, body.law, estimate.tractions) *
                  share_of_contact(estimate.tractions, compared.stress);
  const PenetrationDefect penetration =
      penetration_defect(line, body.law, u_hat, max_norm(body.displacement));
  estimate.penetration = penetration.value;
  const BetweenNodes found =
      between_nodes(line, body.law, estimate.tractions, u_hat);
  const double displacement = std::max(max_norm(body.displacement),
                                       largest_displacement(body.law, u_hat));
  put_between_nodes(
      found,
      std::max(scale, largest_traction(estimate.tractions)) * displacement,
      estimate);
  estimate.reason =
      reason_against(estimate,
                     {mesh.place(line.vertex[penetration.node]),
                      middle_of(mesh, edges, line.edge[found.turned_facet]),
                      middle_of(mesh, edges, line.edge[found.negative_facet])},
                     construction, estimate.unmended.size());
  estimate.admissible = estimate.reason.empty();
}

/// Steps 1 to 6 of the estimate.
Estimate estimate_of(const SolvedProblem& solved, const StressTerms& terms,
                     const EstimateSettings& settings) {
  tell(settings.relaxation.report,
       {"admissible fields", 0, "dofs",
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
  put_error(bodies, u_hat, tractions, settings.construction, estimate);
  estimate.tractions = std::move(tractions.contact);
  estimate.spring_tractions = bodies.spring_tractions();
  if (terms.unstressed)  // to the last digit: above it is what u_hat - u leaves
    for (CompositeStress& zero : estimate.stress) zero.setZero();

  // 6. What the theory promises, measured.
  judge(bodies, u_hat, settings.construction, estimate);
  estimate.refinement = bodies.take_refinement();
  return estimate;
}

}  // namespace

int Estimate::corrected_count() const {
  return static_cast<int>((shift.array() != 0).count());
}

Estimate estimate_error(const Topology& topology, const ContactLine& line,
                        const ElasticSystem& system, const SolvedBody& body,
                        const EstimateSettings& settings) {
  const SolvedProblem solved{topology, line, system, body};
  require_sound(solved, settings);
  require_law_of_matrix(topology.mesh, system, body.hooke, body.springs);
  const double stress_terms =
      largest_stress_terms(topology, line, body, body.displacement);
  if (!is_unstressed(topology, line, system.prescribed, body, stress_terms))
    return estimate_of(solved, {stress_terms, false}, settings);
  SolvedBody unstressed = body;
  unstressed.pressure.setZero();
  return estimate_of({topology, line, system, unstressed}, {stress_terms, true},
                     settings);
}

}  // namespace ffcontact
