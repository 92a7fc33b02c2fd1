// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "ffcontact/estimate/checks/stiffness_comparison.hpp"

namespace ffcontact {

/// "vertex 7 (1, 2)"
template <int dim>
std::string vertex_in_words(const SimplexMesh<dim>& mesh, Index vertex);

/// Is A, but for what other() refuses, K of what the script says? A z is compared with K z
/// for one fixed field z without order.
/// @param other  (comparison, dof): refuses what else may explain the difference at the
///               dof that is off the most
/// @throws std::invalid_argument  naming what A has more, its factor, or the vertex
template <int dim>
void require_forces_of_matrix(
    const SimplexMesh<dim>& mesh, const ElasticSystem& system,
    const StatedForces& forces,
    const std::function<void(const Comparison&, Index)>& other);

}  // namespace ffcontact
