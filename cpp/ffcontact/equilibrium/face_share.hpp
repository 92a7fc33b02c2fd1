// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/mesh/solid_topology.hpp"

namespace ffcontact {

/// What one of several descents has of a solid: its own tetrahedra and, as a halo, those
/// with which they share an edge. Values 1 and 0.
struct FaceShare {
  Flags cell;        ///< its own
  Flags face, edge;  ///< of its own tetrahedra
  Flags counted;     ///< faces whose part in a sum is this share's
};

/// All of it.
FaceShare whole_share(const SolidTopology& topology);

/// @param cell     its own
/// @param counted  faces of these
FaceShare face_share(const SolidTopology& topology, Flags cell, Flags counted);

}  // namespace ffcontact
