// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/boundary_tractions.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"

namespace ffcontact {

using EdgeLoadsOfAll = Eigen::Matrix<double, 12, Eigen::Dynamic>;  ///< EdgeLoads per triangle

/// The edge loads of sigma_hat - sigma on each triangle, where sigma_hat has the given edge moments and sigma is constant per
/// triangle. With the body loads they are in equilibrium on every triangle when sigma_hat is.
EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges, const EdgeMoments& moments,
                                const Eigen::Ref<const Eigen::Matrix3Xd>& stress);

/// Puts the known boundary tractions into the edge loads of sigma_hat - sigma, where they stand but for the rounding of the
/// relaxation: on an edge much shorter than its neighbours that is much of its traction.
void take_known_tractions(const Mesh& mesh, const Edges& edges, const BoundaryTractions& boundary,
                          const Eigen::Ref<const Eigen::Matrix3Xd>& stress, EdgeLoadsOfAll& difference);

TriangleCorners corners_of(const Mesh& mesh, int triangle);

}  // namespace ffcontact
