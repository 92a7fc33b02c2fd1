// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/solid_topology.hpp"

namespace ffcontact {

/// What one of several descents has of a solid: its own tetrahedra and, as a halo, those
/// with which they share an edge. Values 1 and 0.
struct FaceShare {
  std::vector<char> cell;        ///< its own
  std::vector<char> face, edge;  ///< of its own tetrahedra
  std::vector<char> counted;     ///< faces whose part in a sum is this share's
};

/// All of it.
FaceShare whole_share(const SolidTopology& topology);

/// @param cell     its own
/// @param counted  faces of these
FaceShare face_share(const SolidTopology& topology, std::vector<char> cell,
                     std::vector<char> counted);

}  // namespace ffcontact
