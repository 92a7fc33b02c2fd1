// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/cone/boundary_corrections.hpp"

namespace ffcontact {

/// Relaxes the stars of a contact vertex and of those that contact edges join to it
/// across bodies together.
///
/// min y'Hy + 2 g'y + contact cost over the corrections y of the stars that leave known
/// boundary tractions alone and load both bodies of a contact edge oppositely, with r_hat
/// in the cone at the ends of free contact edges.
struct BoundaryChange {
  VectorXd y;       ///< unknowns of the group
  double fall = 0;  ///< of e^2; 0: nothing lowers it, no y
};

/// @param residual  minus half the slope of the elastic part of e^2
/// @param contact   r_hat, relaxed in place
BoundaryChange relax_boundary(const FacetTopology<2>& topology,
                              const FacetForms<2>& forms,
                              const BoundaryTractions& boundary,
                              const StarGroup& group,
                              const FacetColumns<2>& residual,
                              FreeContact& contact);

}  // namespace ffcontact
