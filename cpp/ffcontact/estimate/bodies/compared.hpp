// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/matched_bodies.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"

namespace ffcontact {

/// What sigma_hat and r_hat are compared with: u_hat, or, where u has no stress and
/// slides nowhere, what u_hat differs by from it.
template <int d>
struct Compared {
  VectorXd displacement;
  ContactLaw<d> law;
  LinearStresses<d> stress;  ///< sigma
  /// body loads of sigma_hat - sigma, where they are not those of sigma_hat
  BodyLoadsOfCells<d> other_loads{};

  /// Body loads of sigma_hat - sigma.
  const BodyLoadsOfCells<d>& body_loads(const SolvedBody<d>& body) const {
    return stress.varies() ? other_loads : body.body_loads;
  }
};

template <int d>
Compared<d> compared(const MatchedBodies<d>& bodies, const StressTerms& terms,
                     const VectorXd& u_hat);

}  // namespace ffcontact
