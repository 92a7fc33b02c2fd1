// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/ridges.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

template <int dim>
std::string refusal_of_ridges(const SimplexMesh<dim>& mesh) {
  return refusal([&] { ridges_of(mesh, facets_of(mesh)); });
}

std::set<int> facets_at(const std::vector<int>& start,
                        const std::vector<int>& facet, int ridge) {
  return {facet.begin() + start[ridge], facet.begin() + start[ridge + 1]};
}

RC_GTEST_PROP(Ridges, vertices_edges_faces_and_cells_of_a_solid_obey_euler,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  const int edges = ridges_of(mesh, faces).count();
  RC_ASSERT(mesh.vertex_count() - edges + faces.count() - mesh.cell_count() ==
            1);
}

RC_GTEST_PROP(Ridges, of_a_solid_have_the_faces_that_have_both_their_vertices,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  const Ridges<3> edges = ridges_of(mesh, faces);
  for (int h = 0; h < edges.count(); ++h) {
    std::set<int> expected;
    int on_boundary = 0;
    for (int f = 0; f < faces.count(); ++f) {
      const auto corners = faces.vertices.col(f).array();
      const bool has_it = (corners == edges.vertices(0, h)).any() &&
                          (corners == edges.vertices(1, h)).any();
      if (!has_it) continue;
      expected.insert(f);
      on_boundary += faces.on_boundary(f);
    }
    RC_ASSERT(facets_at(edges.facet_start, edges.facet, h) == expected);
    RC_ASSERT(edges.facet_count(h) == static_cast<int>(expected.size()));
    RC_ASSERT(on_boundary == (edges.on_boundary[h] ? 2 : 0));
  }
}

RC_GTEST_PROP(Ridges, of_a_face_are_opposite_to_its_vertices, (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Facets<3> faces = facets_of(mesh);
  const Ridges<3> edges = ridges_of(mesh, faces);
  for (int f = 0; f < faces.count(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int h = edges.of_facet(k, f);
      const std::set<int> expected{faces.vertices((k + 1) % 3, f),
                                   faces.vertices((k + 2) % 3, f)};
      RC_ASSERT((std::set<int>{edges.vertices(0, h), edges.vertices(1, h)}) ==
                expected);
    }
}

RC_GTEST_PROP(Ridges, of_a_plane_body_are_its_vertices_with_their_spokes,
              (Random random)) {
  const Topology<2> body = topology_of(irregular(3, 3, 3, 3, random));
  const Ridges<2>& ridges = body.ridges;
  RC_ASSERT(ridges.count() == body.mesh.vertex_count());
  for (int v = 0; v < ridges.count(); ++v) {
    RC_ASSERT(ridges.vertices(0, v) == v);
    std::set<int> expected;
    for (int f = 0; f < body.facets.count(); ++f)
      if ((body.facets.vertices.col(f).array() == v).any()) expected.insert(f);
    RC_ASSERT(facets_at(ridges.facet_start, ridges.facet, v) == expected);
    // one facet more than cells where they do not go around
    RC_ASSERT((ridges.on_boundary[v] == 1) ==
              (ridges.facet_count(v) > body.stars.count(v)));
  }
}

/// Two unit tetrahedra that have nothing but the edge 0, 1 in common.
TEST(Ridges, refuses_a_body_that_touches_itself_in_a_single_edge) {
  SolidMesh mesh;
  mesh.vertices.resize(3, 6);
  mesh.vertices << 0, 0, 1, 0, -1, 0,  //
      0, 0, 0, 1, 0, -1,               //
      0, 1, 0, 0, 0, 0;
  mesh.cells.resize(4, 2);
  mesh.cells << 0, 0, 2, 4, 3, 5, 1, 1;
  add_boundary(mesh);
  require_valid(mesh);
  EXPECT_EQ(
      refusal_of_ridges(mesh),
      "the body touches itself in the single edge between vertices 0 and 1");
}

TEST(Ridges, refuses_a_plane_body_that_touches_itself_in_a_single_vertex) {
  Mesh mesh;
  mesh.vertices.resize(2, 5);
  mesh.vertices << 0, 1, 0, -1, 0, 0, 0, 1, 0, -1;
  mesh.cells.resize(3, 2);
  mesh.cells << 0, 0, 1, 3, 2, 4;
  mesh.boundary.resize(2, 6);
  mesh.boundary << 0, 1, 2, 0, 3, 4, 1, 2, 0, 3, 4, 0;
  mesh.boundary_label = VectorXi::Ones(6);
  EXPECT_EQ(refusal_of_ridges(mesh),
            "the body touches itself in the single vertex 0");
}

}  // namespace
}  // namespace ffcontact
