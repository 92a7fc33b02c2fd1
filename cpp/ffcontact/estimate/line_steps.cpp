// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/bodies/contact_subset.hpp"
#include "ffcontact/estimate/contact_steps.hpp"
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "ffcontact/estimate/displacement/bonded_displacement.hpp"
#include "ffcontact/estimate/displacement/sticking_displacement.hpp"
#include "ffcontact/estimate/error/contact_edges.hpp"
#include "ffcontact/estimate/error/contact_error.hpp"
#include "ffcontact/estimate/error/line_oscillation.hpp"
#include "ffcontact/estimate/error/wide_cones.hpp"
#include "ffcontact/interface/curve_directions.hpp"

namespace ffcontact {

template <>
Matrix2Xd carried_tractions(const SolvedProblem<2>& solved) {
  return nodal_pressures(solved);
}

template <>
VectorXd displacement_of_pair(const SolvedProblem<2>& solved,
                              const MatchedBodies<2>& bodies) {
  const auto& [line, law, nodes] =
      sliding_subset<2>(bodies.contact(), bodies.body().law);
  const Flags held = held_with_bonded<2>(bodies.contact(), bodies.body().law,
                                         bodies.prescribed());
  const VectorXd clear = sticking_displacement(
      bodies, nodal_pressures(solved),
      admissible_displacement(line, law, bonded_displacement(bodies), held));
  return cleared_between_nodes(line, law, clear, held);
}

template <>
std::vector<ContactFacet<2>> contact_facets(
    const MatchedBodies<2>& bodies, const Compared<2>& compared,
    const ContactTractions<2>& tractions, const BoundaryTractions& boundary) {
  return contact_edges(bodies.contact(), compared.law, compared.displacement,
                       tractions.densities, boundary);
}

template <>
std::vector<FacingOscillation<2>> facing_oscillations(
    const MatchedBodies<2>&, const std::vector<ContactFacet<2>>&,
    const ContactTractions<2>&) {
  return {};
}

template <>
void put_relaxed(const MatchedBodies<2>& bodies,
                 const EstimateSettings<2>& settings,
                 const std::vector<ContactFacet<2>>& relaxed,
                 RelaxedTractions<2>& tractions) {
  ContactDensities& densities = tractions.contact.densities;
  put_tractions(relaxed, tractions.moments, densities);
  if (settings.tractions != Tractions::published)
    clamp_rounding(bodies.contact(), bodies.body().law, densities);
  tractions.boundary = bodies.boundary_with(densities);
  put_known(tractions.boundary, tractions.moments);
}

template <>
VectorXd contact_part_of(const MatchedBodies<2>& bodies,
                         const Compared<2>& compared,
                         const RelaxedTractions<2>& tractions) {
  return contact_error(bodies.contact(), compared.law,
                       tractions.contact.densities, compared.displacement);
}

template <>
SpringNorms layer_norms_of(const MatchedBodies<2>& bodies,
                           const RelaxedTractions<2>& tractions) {
  return layer_norms(bodies.contact(), bodies.body().law,
                     tractions.contact.densities);
}

template <>
void add_contact_part(const MatchedBodies<2>& bodies, const VectorXd& part,
                      VectorXd& local) {
  add_to_cells(bodies.topology().facets, bodies.contact(), part, local);
}

template <>
double largest_traction(const ContactTractions<2>& contact) {
  return largest_traction(contact.densities);
}

template <>
double cone_violation(const MatchedBodies<2>& bodies,
                      const RelaxedTractions<2>& tractions) {
  const ContactDensities& densities = tractions.contact.densities;
  return cone_defect(bodies.contact(), bodies.body().law, densities) *
         largest_traction(densities);
}

template <>
DeepestNode deepest_node(const MatchedBodies<2>& bodies,
                         const VectorXd& u_hat) {
  return deepest_node(bodies.contact(), bodies.body().law, u_hat);
}

template <>
BetweenNodes between_nodes(const MatchedBodies<2>& bodies,
                           const ContactTractions<2>& contact,
                           const VectorXd& u_hat) {
  return between_nodes(bodies.contact(), bodies.body().law, contact.densities,
                       u_hat);
}

namespace {

/// Does e pay for next to nothing but friction without bound on the slip between the nodes of
/// a curve, where no u_hat sticks that keeps clear?
bool pays_for_rough_edges(const MatchedBodies<2>& bodies,
                          const PairError& error) {
  const ContactLaw<2>& law = bodies.body().law;
  return turns(bodies.contact()) && pays_for_contact_alone(error) &&
         (law.tresca() || law.friction.maxCoeff() > most_friction);
}

}  // namespace

template <>
std::string reason_of(const MatchedBodies<2>& bodies,
                      const RelaxedTractions<2>& tractions,
                      const WorstPlaces& worst,
                      const EstimateSettings<2>& settings,
                      const Estimate<2>& estimate) {
  const std::string reason =
      reason_against(estimate, worst, settings.construction,
                     tractions.contact.unmended.size());
  if (reason.empty() && pays_for_rough_edges(bodies, estimate))
    return "e pays the bound of friction times what displacements slip between "
           "the nodes of a curve: where nothing slips there give friction= or "
           "slipbound= no larger than the contact needs";
  return reason;
}

template <>
void put_fields(MatchedBodies<2>& bodies, RelaxedTractions<2> tractions,
                Estimate<2>& estimate) {
  const auto& [mesh, edges, ridges, stars] = bodies.topology();
  estimate.oscillation =
      line_oscillation(mesh, edges, bodies.contact(), bodies.body().hooke,
                       tractions.contact.densities);
  estimate.tractions = std::move(tractions.contact.densities);
  estimate.shift = std::move(tractions.contact.shift);
  estimate.unmended = std::move(tractions.contact.unmended);
  estimate.spring_tractions = bodies.spring_tractions();
  estimate.refinement = bodies.take_refinement();
}

}  // namespace ffcontact
