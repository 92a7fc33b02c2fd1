// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/unstressed.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/elastic/stress_terms.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// What a displacement as large as the gap or that of the load step before would stress along
/// each contact facet on either side.
template <int d>
double terms_along_contact(const Topology<d>& topology,
                           const LineOrSurface<d>& contact,
                           const SolvedBody<d>& body) {
  const double given =
      std::max(max_norm(body.law.gap), max_norm(body.law.previous));
  double largest = 0;
  if (given == 0) return largest;
  for_touching_facets(contact, [&](int facet, int place) {
    const double stiffness =
                     max_norm(body.hooke[topology.facets.cells(0, facet)]),
                 measure = facet_measure(topology.mesh, topology.facets,
                                         facets_of(contact)[place]),
                 length = std::pow(measure, 1.0 / (d - 1));
    largest = std::max(largest, stiffness * given / length);
  });
  return largest;
}

/// Loads on supports are felt by nothing.
template <int d>
bool has_loads(const SolvedProblem<d>& solved) {
  const auto& [topology, contact, system, body] = solved;
  const FacetTractions<d> carried =
      given_tractions<d>(topology.mesh, topology.facets, system.prescribed,
                         boundary_moments<d>(topology.mesh, body));
  return !carried.moments.isZero(0) || !body.body_loads.isZero(0);
}

/// Does a node slide against Tresca's friction? Then stresses are not rounding, however
/// small.
template <int d>
bool slides(const SolvedProblem<d>& solved) {
  const auto& [topology, contact, system, body] = solved;
  const VectorXd& bound = body.law.slip_bound;
  if (bound.size() == 0) return false;
  const VectorXd slip =
      displacement_against_foundation(contact, body.law, body.displacement)
          .bottomRows(d - 1)
          .colwise()
          .norm();
  const double least =
      rounding_of_terms * largest_displacement(body.law, body.displacement);
  return (slip.cwiseProduct(bound).array() > least * bound.array()).any();
}

/// Of u_h [MPa].
template <int d>
double largest_contact_traction(const SolvedProblem<d>& solved) {
  const double largest = max_norm(solved.body.multipliers);
  if constexpr (d == 3) return largest / solved.contact.area.minCoeff();
  return largest;
}

}  // namespace

template <int d>
double largest_stress_terms(const Topology<d>& topology,
                            const LineOrSurface<d>& contact,
                            const SolvedBody<d>& body,
                            const VectorXd& displacement) {
  return std::max(
      {terms_along_contact(topology, contact, body), body.initial.bound(),
       largest_stress_terms(topology.mesh, body.hooke, displacement)});
}

template <int d>
StressTerms stress_terms_of(const SolvedProblem<d>& solved) {
  const auto& [topology, contact, system, body] = solved;
  const double terms = largest_stress_terms<d>(topology, contact, body,
                                               body.displacement),
               stress = total_stresses(topology.mesh, body, body.displacement)
                            .bound();
  const bool are_rounding =
      std::max(stress, largest_contact_traction(solved)) <=
      rounding_of_terms * terms;
  return {terms, are_rounding && !has_loads(solved) && !slides(solved)};
}

template double largest_stress_terms(const Topology<FFCONTACT_DIMENSION>&,
                                     const LineOrSurface<FFCONTACT_DIMENSION>&,
                                     const SolvedBody<FFCONTACT_DIMENSION>&,
                                     const VectorXd&);
template StressTerms stress_terms_of(const SolvedProblem<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
