// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/estimate/tractions/carrying_edges.hpp"

namespace ffcontact {

/// The tractions in the cone that are nearest to given ones and have given resultants:
///     min 1/2 sum over the edges of int |r - r_0|^2    for r in EdgeCone,    sum over the edges of int [z_k] . r = R_k.
///
/// Densities may jump at the nodes. By duality r = Pi_C(r_0 + sum eta_k [z_k]), edge by
/// edge, where the multipliers eta, one per motion z_k, minimise a convex function whose
/// gradient is what the resultants are off. It is quadratic in pieces: Newton's method
/// with a line search ends at the minimum, and runs away when no tractions in the cone
/// have these resultants.
/// @param motions     vertex fields z_k, linear on the edges [2 * vertices x k]
/// @param resultants  R_k [k]
/// @param carrying    what each edge may carry; none: all of the cone
/// @return nothing if there are no such tractions
std::optional<ContactDensities> nearest_in_cone(
    const ContactLine& line, const ContactLaw<2>& law,
    const ContactDensities& densities, const MatrixXd& motions,
    const VectorXd& resultants, const std::vector<Carrying>& carrying = {});

/// int [z_k] . r over all edges [k].
VectorXd resultants_of(const ContactLine& line,
                       const ContactDensities& densities,
                       const MatrixXd& motions);

}  // namespace ffcontact
