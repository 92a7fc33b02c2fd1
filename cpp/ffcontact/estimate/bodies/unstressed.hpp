// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/flags.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// Stresses and displacements below this part of the terms that they are summed from are
/// the rounding of these.
constexpr double rounding_of_terms = 1e-12;

/// Equilibrium is judged against stresses and moments, and against this part of the terms
/// that stresses are summed from: 1e-10 of it is some five hundred units in their last
/// place.
constexpr double least_part_of_terms = 1e-3;

/// The scale of the stresses' rounding.
struct StressTerms {
  double stress;    ///< largest_stress_terms of u_h [MPa]
  bool unstressed;  ///< is_unstressed
};

/// Largest |C| |grad phi_k| |u_k|, summed over the vertices of a triangle, or initial
/// stress, or what the gap and the displacement of the load step before come to as
/// strains along the line [MPa].
double largest_stress_terms(const Topology<2>& topology,
                            const ContactLine& line, const SolvedBody<2>& body,
                            const VectorXd& displacement);

/// Bodies without loads whose stresses and tractions are rounding, and that slide nowhere
/// against Tresca's friction: rigid motions.
/// @param prescribed    1 where the dof is prescribed [2 * vertices]
/// @param stress_terms  largest_stress_terms of u_h
bool is_unstressed(const Topology<2>& topology, const ContactLine& line,
                   const Flags& prescribed, const SolvedBody<2>& body,
                   double stress_terms);

}  // namespace ffcontact
