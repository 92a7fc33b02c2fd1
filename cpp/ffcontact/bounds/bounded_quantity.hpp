// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/bounds/bound_pair.hpp"
#include "ffcontact/bounds/quantity.hpp"

namespace ffcontact {

/// A quantity l of a solved problem, on bodies whose traces match, and what pairs that bound it
/// keep to.
template <int d>
struct BoundedQuantity {
  SolvedProblem<d> solved;
  const Estimate<d>& first;  ///< its estimate
  Quantity<d> quantity;      ///< on the solved bodies
  VectorXd load;             ///< l of their hat functions

  MatchedBodies<d> bodies;
  Quantity<d> matched;    ///< on these
  VectorXd matched_load;  ///< l of their hat functions
  double stress;          ///< |sigma_h|

  /// under which v is sought, and which it keeps to on the matched bodies
  ContactConditions<d> sought, clear;
  VectorXd further_load;  ///< under which v is sought, beside L - t l - rho
  std::optional<CoulombTerms<d>> coulomb{};

  /// l(v), of v on the matched bodies.
  double of(const VectorXd& v) const {
    return matched_load.dot(v) + matched.constant;
  }
  double of_solution() const { return of(bodies.body().displacement); }
  /// Null for other laws than Coulomb's.
  const CoulombTerms<d>* coulomb_terms() const {
    return coulomb ? &*coulomb : nullptr;
  }
};

/// Without friction and with Tresca's law: v keeps clear, and is sought under twice the slip
/// bound.
/// @param solved, first  stay where they are
template <int d>
BoundedQuantity<d> bounded_quantity(const SolvedProblem<d>& solved,
                                    const Estimate<d>& first,
                                    const Quantity<d>& quantity);

}  // namespace ffcontact
