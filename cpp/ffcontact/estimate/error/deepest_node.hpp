// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// The node at which u_n - gap is largest, and by how much it is above 0 [mm]; of bonded
/// bodies that at which the jump of u is.
struct DeepestNode {
  double depth = 0;
  int node = 0;
};

}  // namespace ffcontact
