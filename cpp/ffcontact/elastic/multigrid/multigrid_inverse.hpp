// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/linear/iterative/krylov.hpp"

namespace ffcontact {

/// Free dofs of a solid from which on multigrid is faster than a factor.
constexpr int multigrid_pays_from = 20000;

/// f -> u near K^-1 f on the free dofs, by conjugate gradients with SmoothedAggregation to a
/// residual of 1e-6 of f; 0 where they do not get there. Of a singular K some u, where f
/// does no work on its rigid motions.
/// @param system    outlives it
/// @param vertices  of the mesh
LinearMap multigrid_inverse(const ElasticSystem& system,
                            const Matrix3Xd& vertices);

}  // namespace ffcontact
