// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// A mesh with its edges and stars: made once, and handed on as one.
struct Topology {
  Mesh mesh;
  Edges edges;
  Stars stars;
};

/// @throws std::invalid_argument  as edges_of and stars_of
Topology topology_of(Mesh mesh);

}  // namespace ffcontact
