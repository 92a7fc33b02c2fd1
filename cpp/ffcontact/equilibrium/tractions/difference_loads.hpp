// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

namespace ffcontact {

using EdgeLoadsOfAll = Matrix<double, 12, Dynamic>;  ///< EdgeLoads per triangle

/// The edge loads of sigma_hat - sigma on each triangle, where sigma_hat has the given
/// edge moments. With the body loads of sigma_hat, less those of sigma
/// (balancing_loads), they are in equilibrium on every triangle when sigma_hat is.
EdgeLoadsOfAll difference_loads(const Mesh& mesh, const Edges& edges,
                                const EdgeMoments& moments,
                                const LinearStresses& stresses);

TriangleCorners corners_of(const Mesh& mesh, int triangle);

Vector2d centroid_of(const Mesh& mesh, int triangle);

}  // namespace ffcontact
