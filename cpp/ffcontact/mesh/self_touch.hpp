// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Where labelled edges of a mesh touch each other without a common vertex, as the sides
/// of a closed crack: a vertex of one that is nearer to another one than 4e-9 of the
/// mesh's extent. A remesher that works with integer coordinates, as BAMG does, cannot
/// tell these apart.
/// @return such a vertex, or nothing
std::optional<int> self_touch(const Mesh& mesh);

}  // namespace ffcontact
