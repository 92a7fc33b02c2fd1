// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// What sigma_hat and r_hat are compared with: u_hat, or, where u has no stress and
/// slides nowhere, what u_hat differs by from it.
struct Compared {
  VectorXd displacement;
  ContactLaw law;
  LinearStresses<2> stress;  ///< sigma
  /// body loads of sigma_hat - sigma, where they are not those of sigma_hat
  BodyLoadsOfCells<2> other_loads{};

  /// Body loads of sigma_hat - sigma.
  const BodyLoadsOfCells<2>& body_loads(const SolvedBody<2>& body) const {
    return stress.varies() ? other_loads : body.body_loads;
  }
};

Compared compared(const MatchedBodies& bodies, const VectorXd& displacement);

/// @param stress_terms  largest_stress_terms of u_h [MPa]
Compared compared_change(const MatchedBodies& bodies, double stress_terms,
                         const VectorXd& u_hat);

}  // namespace ffcontact
