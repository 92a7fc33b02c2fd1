// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/estimate/tractions/contact_tractions.hpp"

namespace ffcontact {

/// r_hat, and facet tractions in equilibrium with it on every cell of the matched bodies.
template <int d>
struct FirstTractions {
  ContactTractions<d> contact;
  FacetColumns<d> moments;
  /// that sliding motions (RigidMotions) have to be held by against loads and r_hat, before
  /// there are moments; no columns where they are balanced
  BodyLoadsOfCells<d> holding{d * (d + 1), 0};
};

/// Tractions in the cone are not those that u_h was computed with: one back-substitution
/// gives the small displacement whose stresses make up for the difference, and one or two
/// more its rounding (Rebalancing); springs answer it. By multigrid it is solved to 1e-6 of the
/// largest moment, and what cells lack then goes to the supports (sweep_to_roots), as wherever
/// rounding is not reached. After solves to rounding cells are balanced as well without.
/// @param u_hat  admissible displacement of the matched bodies
/// @throws std::invalid_argument  if loads and stresses do not balance each other, with
///                                the cause, or where no tractions in the cone hold the
///                                body
template <int d>
FirstTractions<d> first_tractions(const SolvedProblem<d>& solved,
                                  MatchedBodies<d>& bodies,
                                  const StressTerms& terms,
                                  const EstimateSettings<d>& settings,
                                  const Ref<const VectorXd>& u_hat);

}  // namespace ffcontact
