// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/equilibrium/cone/star_columns.hpp"
#include "ffcontact/equilibrium/tractions/contact_facet.hpp"

namespace ffcontact {

/// Corrections of contact tractions where the meshes of two bodies do not match.
///
/// Around a ridge of contact facets that have a FacingPart each, the facets of their own body
/// carry one wrench w, and these two have modes, as in any star: x = (w, y_1, y_2), or x = y_1
/// where the other facet is none of them. r_hat changes by R x, and a facet k that they face
/// must carry the moments W_k R x: its modes are theirs, and its wrench w_k passes through the
/// ridges between these facets, along a tree of them, from the leaves to the root:
///     s_k Shift_k w_ridge = w_k - sum of what comes through the ridges of its branches.
/// At the root nothing is left where the distance of the surfaces is the same all over them;
/// else those x are left out that leave something. Modes inside are those of the least energy
/// (with_least_modes).
template <int d>
struct FacingStar {
  std::vector<int> contact;         ///< places of the contact facets
  std::vector<MatrixXd> tractions;  ///< R of each, by t [d^2 x k]
  StarColumns<d> columns;           ///< of t
};

/// Those around all ridges, in the order in which contact facets have them.
/// @return no star without corrections, or where what they face does not hang together
template <int d>
std::vector<FacingStar<d>> facing_stars(
    const FacetTopology<d>& topology,
    const std::vector<ContactFacet<d>>& contact);

}  // namespace ffcontact
