// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Nodes of a contact line or surface in d dimensions.
struct PlacedNodes {
  MatrixXd place;   ///< [mm, d x p]
  MatrixXd normal;  ///< contact directions [d x p]
  VectorXd size;    ///< h, of what belongs to each [mm, p]; old ones need none
};

/// The old node nearest to each new one, of least |x - y|^2 + h^2 |n - m|^2: where sheets meet
/// at an edge several nodes are at one place, and a direction that differs counts as a
/// distance of the node's size.
/// @param old  at least one
std::vector<int> nearest_nodes(const PlacedNodes& nodes,
                               const PlacedNodes& old);

}  // namespace ffcontact
