// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

namespace ffcontact {

/// Is A the stiffness K of the law and of the springs? Compares A z with K z on the free
/// dofs for one fixed field z without order that is 0 on the prescribed dofs; each row to
/// 1e-6 of the terms it sums.
/// @throws std::invalid_argument  saying by what factor A is off, or where it has
///                                something on its diagonal that the law has not (a
///                                penalty that does not prescribe), on the boundary
///                                alone (springs), that it is an axisymmetric body's, or
///                                where it is off
template <int d>
void require_law_of_matrix(const SimplexMesh<d>& mesh,
                           const ElasticSystem& system,
                           const HookeTensors<d>& hooke,
                           const BoundarySprings<d>& springs = {});

}  // namespace ffcontact
