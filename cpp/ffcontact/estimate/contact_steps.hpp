// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ffcontact/estimate/admissible_pair.hpp"
#include "ffcontact/estimate/bodies/compared.hpp"
#include "ffcontact/estimate/checks/reason_against.hpp"
#include "ffcontact/estimate/error/deepest_node.hpp"
#include "ffcontact/estimate/layer/layer_parts.hpp"
#include "ffcontact/estimate/tractions/first_tractions.hpp"

namespace ffcontact {

/// What the steps of an estimate ask of the contact: lines and surfaces answer each in their
/// own way.

/// sigma_hat, by its moments on the facets, and r_hat.
template <int d>
struct RelaxedTractions {
  ContactTractions<d> contact;
  FacetColumns<d> moments;
  std::vector<ContactFacet<d>> facets{};  ///< whose tractions may be relaxed
  FacetTractions<d> boundary{};           ///< what it carries with r_hat
  std::vector<double> falls{};            ///< of e^2, step by step
};

/// The tractions at the nodes that a compliant layer carries in the solution [MPa, d x p].
template <int d>
Matrix<double, d, Dynamic> carried_tractions(const SolvedProblem<d>& solved);

/// Step 1: u_hat, which keeps clear, and sticks where friction is rough; or hangs together
/// where bodies are bonded.
template <int d>
VectorXd displacement_of_pair(const SolvedProblem<d>& solved,
                              const MatchedBodies<d>& bodies);

/// Step 4: the contact facets whose tractions may be relaxed, all but those that stay
/// unloaded (outweighs_all_gains).
/// @param boundary  what it carries with these tractions
template <int d>
std::vector<ContactFacet<d>> contact_facets(
    const MatchedBodies<d>& bodies, const Compared<d>& compared,
    const ContactTractions<d>& tractions, const FacetTractions<d>& boundary);

/// What other facets that face these do not carry of their tractions, for the relaxation; none
/// in the plane, where traces match.
/// @param tractions  before it
template <int d>
std::vector<FacingOscillation<d>> facing_oscillations(
    const MatchedBodies<d>& bodies, const std::vector<ContactFacet<d>>& contact,
    const ContactTractions<d>& tractions);

/// r_hat of sigma_hat on the facets that were relaxed, in the cone where it is but for
/// rounding, and what the boundary carries with it.
template <int d>
void put_relaxed(const MatchedBodies<d>& bodies,
                 const EstimateSettings<d>& settings,
                 const std::vector<ContactFacet<d>>& relaxed,
                 RelaxedTractions<d>& tractions);

/// Step 5: the contact part of e^2 on each contact facet.
template <int d>
VectorXd contact_part_of(const MatchedBodies<d>& bodies,
                         const Compared<d>& compared,
                         const RelaxedTractions<d>& tractions);

/// What a compliant layer adds to it, on each contact facet.
template <int d>
SpringNorms layer_norms_of(const MatchedBodies<d>& bodies,
                           const RelaxedTractions<d>& tractions);

/// Adds it to the cells of the facets; in the plane one half of it, where an edge of another
/// body faces the whole facet, to the cell of that.
template <int d>
void add_contact_part(const MatchedBodies<d>& bodies, const VectorXd& part,
                      VectorXd& local);

/// Step 6: largest component of r_hat, and how far it is out of the cone [MPa].
template <int d>
double largest_traction(const ContactTractions<d>& contact);
template <int d>
double cone_violation(const MatchedBodies<d>& bodies,
                      const RelaxedTractions<d>& tractions);

template <int d>
DeepestNode deepest_node(const MatchedBodies<d>& bodies, const VectorXd& u_hat);

template <int d>
BetweenNodes between_nodes(const MatchedBodies<d>& bodies,
                           const ContactTractions<d>& contact,
                           const VectorXd& u_hat);

/// Why the pair is not admissible, or nothing.
template <int d>
std::string reason_of(const MatchedBodies<d>& bodies,
                      const RelaxedTractions<d>& tractions,
                      const WorstPlaces& worst,
                      const EstimateSettings<d>& settings,
                      const Estimate<d>& estimate);

/// Moves the fields of the pair into the estimate.
template <int d>
void put_fields(MatchedBodies<d>& bodies, RelaxedTractions<d> tractions,
                Estimate<d>& estimate);

}  // namespace ffcontact
