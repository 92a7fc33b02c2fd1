// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/solid_topology.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SolidTopology, stars_have_every_corner_once, (Random random)) {
  const SolidTopology topology = topology_of(irregular_solid(random));
  const SolidStars& stars = topology.stars;
  const SolidMesh& mesh = topology.mesh;
  RC_ASSERT(stars.start.back() == 4 * mesh.cell_count());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    for (int k = stars.start[v]; k < stars.start[v + 1]; ++k) {
      RC_ASSERT(mesh.cells(stars.local[k], stars.cell[k]) == v);
      if (k > stars.start[v]) RC_ASSERT(stars.cell[k - 1] < stars.cell[k]);
    }
}

}  // namespace
}  // namespace ffcontact
