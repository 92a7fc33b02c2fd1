// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/estimate/bodies/estimate_settings.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"

namespace ffcontact {

/// Contact tractions r_hat, and those that stresses have to balance.
struct ContactTractions {
  ContactDensities densities, balanced;
  VectorXd shift;               ///< d of (4.1) per edge [MPa]
  std::vector<int> unmended{};  ///< edges that (4.1) leaves outside the cone
};

/// r_hat before the relaxation, and edge tractions in equilibrium with it on every
/// triangle of the matched bodies.
struct FirstTractions {
  ContactTractions contact;
  EdgeMoments moments;
};

/// p_i = F_i / len_i of lambda_h [2 x p].
Matrix2Xd nodal_pressures(const SolvedProblem<2>& solved);

/// Tractions of the kind that is asked for. Those in the cone are not those that u_h was
/// computed with: one back-substitution gives the small displacement whose stresses make
/// up for the difference, and one or two more its rounding (Rebalancing); springs answer
/// it.
/// @param u_hat  admissible displacement of the matched bodies
/// @throws std::invalid_argument  if loads and stresses do not balance each other, with
///                                the cause, or where no tractions in the cone hold the
///                                body
FirstTractions first_tractions(const SolvedProblem<2>& solved,
                               MatchedBodies& bodies, const StressTerms& terms,
                               Tractions kind,
                               const Ref<const VectorXd>& u_hat);

}  // namespace ffcontact
