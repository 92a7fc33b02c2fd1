// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/topology.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

template <int d>
void stars_have_every_corner_once(const SimplexMesh<d>& mesh) {
  const Topology<d> topology = topology_of(mesh);
  const Stars& stars = topology.stars;
  RC_ASSERT(stars.start.back() == (d + 1) * mesh.cell_count());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    for (int k = stars.start[v]; k < stars.start[v + 1]; ++k) {
      RC_ASSERT(mesh.cells(stars.local[k], stars.cell[k]) == v);
      if (k > stars.start[v]) RC_ASSERT(stars.cell[k - 1] < stars.cell[k]);
    }
}

RC_GTEST_PROP(Topology, stars_have_every_corner_once, (Random random)) {
  stars_have_every_corner_once(irregular(4, 3, 4, 3, random));
  stars_have_every_corner_once(irregular_solid(random));
}

template <int d>
void boundary_facets_of_a_vertex_have_it(const SimplexMesh<d>& mesh) {
  const Topology<d> topology = topology_of(mesh);
  const Facets<d>& facets = topology.facets;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    std::set<int> found, expected;
    for_boundary_facets(topology, v, [&](int f) { found.insert(f); });
    for (int f = 0; f < facets.count(); ++f)
      if (facets.on_boundary(f) && (facets.vertices.col(f).array() == v).any())
        expected.insert(f);
    RC_ASSERT(found == expected);
  }
}

RC_GTEST_PROP(Topology, boundary_facets_of_a_vertex_have_it, (Random random)) {
  boundary_facets_of_a_vertex_have_it(irregular(4, 3, 4, 3, random));
  boundary_facets_of_a_vertex_have_it(irregular_solid(random));
}

TEST(Topology, a_vertex_without_cells_has_an_empty_star) {
  Mesh mesh = rectangle(1, 1, 1, 1);
  mesh.vertices.conservativeResize(Eigen::NoChange, 5);
  mesh.vertices.col(4) << 9, 9;
  EXPECT_EQ(topology_of(mesh).stars.count(4), 0);
}

TEST(Topology, refuses_a_body_that_touches_itself_in_a_vertex) {
  Mesh mesh = joined(rectangle(1, 1, 1, 1), rectangle(1, 1, 1, 1));
  mesh.vertices.rightCols(4).array() += 1;
  const auto glue = [](int& v) {
    v = v == 4 ? 3 : v;
  };  // lower left corner of the second onto upper right of the first
  for (int& v : mesh.cells.reshaped()) glue(v);
  for (int& v : mesh.boundary.reshaped()) glue(v);
  EXPECT_EQ(refusal([&] { topology_of(mesh); }),
            "the body touches itself in the single vertex 3");
}

}  // namespace
}  // namespace ffcontact
