// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// The dofs of a part's vertices in the whole.
/// @param vertex  in the whole, of each of the part's
std::vector<int> dofs_of_part(const std::vector<int>& vertex, int dimension);

/// A body whose matrix was assembled in parts, each over its own cells:
///     K = sum of K_r,   b = sum of b_r.
/// A dof is prescribed where it is in one part; its columns of the others go to the right,
///     b_f = sum of b_r,f - K_r,fp u_p.
/// @param vertex  MeshParts::vertex
/// @throws std::invalid_argument  if a part has not the dofs of its vertices, or two parts
///                                prescribe different values to one dof
ElasticSystem joined_parts(const std::vector<ElasticSystem>& parts,
                           const std::vector<std::vector<int>>& vertex);

}  // namespace ffcontact
