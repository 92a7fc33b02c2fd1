// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

/// Boxes of irregular cells, of properties that hold in any dimension.
namespace ffcontact::test {

/// The property name<d>(random), in the plane and in space.
#define PROPERTY_IN_BOTH_DIMENSIONS(suite, name) \
  RC_GTEST_PROP(suite, name, (Random random)) {  \
    name<2>(random);                             \
    name<3>(random);                             \
  }

template <int d>
SimplexMesh<d> irregular_body(Random& random) {
  if constexpr (d == 2)
    return irregular(4, 3, 4, 3, random);
  else
    return irregular_solid(random);
}

/// The sizes of such a box.
template <int d>
VectorOf<d> body_sizes() {
  return Vector3d(d == 2 ? 4 : 3, d == 2 ? 3 : 2, 2).head<d>();
}

/// The outward normal of a side of it.
template <int d>
VectorOf<d> outward_of_side(int label) {
  const Vector2d sides[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  if constexpr (d == 2)
    return sides[label - bottom];
  else
    return Vector3d::Unit((label - low_x) / 2) *
           ((label - low_x) % 2 == 0 ? -1 : 1);
}

}  // namespace ffcontact::test
