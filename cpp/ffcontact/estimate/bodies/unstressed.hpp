// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// Stresses and displacements below this part of the terms that they are summed from are
/// the rounding of these.
constexpr double rounding_of_terms = 1e-12;

/// Equilibrium is judged against stresses and moments, and against this part of the terms
/// that stresses are summed from: 1e-10 of it is some five hundred units in their last
/// place.
constexpr double least_part_of_terms = 1e-3;

/// Largest |C| |grad phi_k| |u_k|, summed over the vertices of a cell, or initial stress, or
/// what the gap and the displacement of the load step before come to as strains along the
/// contact [MPa].
template <int d>
double largest_stress_terms(const Topology<d>& topology,
                            const LineOrSurface<d>& contact,
                            const SolvedBody<d>& body,
                            const VectorXd& displacement);

/// The scale of the stresses' rounding.
struct StressTerms {
  double stress;  ///< largest_stress_terms of u_h [MPa]
  /// bodies without loads whose stresses and tractions are rounding, and that slide nowhere
  /// against Tresca's friction: rigid motions
  bool unstressed;
};
template <int d>
StressTerms stress_terms_of(const SolvedProblem<d>& solved);

}  // namespace ffcontact
