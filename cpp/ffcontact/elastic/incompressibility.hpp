// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The largest lambda/G that the matrix of linear elements tells. Two vertices of an edge
/// whose cells have the same isotropic material have the block
///     K_ij = lambda N + G (N' + tr N I),   N = sum over these cells of |E| g_i g_j',
/// g the gradients of the hats. lambda and G are fitted to the blocks of free dofs; a block
/// that they do not fit to 1e-6, as at springs or an interface of materials, says nothing.
/// Of many vertices some thousand are asked.
/// @param first, end  vertices of a body
/// @return 0 where no block says anything
template <int dim>
double largest_bulk_over_shear(const SimplexMesh<dim>& mesh,
                               const ElasticSystem& system, int first, int end);

}  // namespace ffcontact
