// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/local_rates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A square (0, 1) x (0, 1) all of whose boundary tractions are known.
struct Square {
  Topology<2> topology;
  const Mesh& mesh = topology.mesh;
  const Edges& edges = topology.facets;
  BoundaryTractions boundary;
  std::vector<int> contact_edge;
  explicit Square(int cells)
      : topology(topology_of(rectangle(cells, cells, 1, 1))) {
    boundary.known.setConstant(2, edges.count(), false);
    boundary.moments = EdgeMoments::Zero(4, edges.count());
    for (int e = 0; e < edges.count(); ++e)
      boundary.known.col(e) = edges.on_boundary(e);
    contact_edge.assign(edges.count(), -1);
  }
  /// Vertices with exponents for a stress of the size |x|^(alpha - 1), whose energy in
  /// discs is r^(2 alpha).
  std::vector<SingularVertex> singular(double alpha) const {
    Matrix3Xd stress(3, mesh.cells.cols());
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const Vector2d x =
          (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
      stress.col(t) = std::pow(x.norm(), alpha - 1) * Vector3d(1, -0.5, 0.3);
    }
    return singular_vertices(topology,
                             Hooke(mesh.cell_count(), isotropic(1, 1)), stress,
                             boundary, contact_edge);
  }
};

/// Discs are as large as so many cells: of a power the exponents do not depend on the mesh.
/// What the cells beside the vertex miss of it, by their stresses in the middle, makes them
/// larger, by 0.11 (1 - alpha) at 0.4, less above and nothing at 1.
TEST(SingularVertices, have_the_exponent_of_the_energy_in_discs) {
  const Square coarse(20), fine(40);
  for (double alpha : {0.4, 0.5, 0.7, 1.0}) {
    const SingularVertex found = coarse.singular(alpha).front();
    ASSERT_EQ(found.vertex, 0);
    EXPECT_GT(found.exponent, alpha - 1e-12);
    EXPECT_LT(found.exponent, alpha + 0.12 * (1 - alpha) + 1e-12);
    EXPECT_NEAR(fine.singular(alpha).front().exponent, found.exponent, 1e-12);
  }
}

TEST(SingularVertices, have_exponents_near_one_away_from_the_singularity) {
  const std::vector<SingularVertex> found = Square(40).singular(0.5);
  for (std::size_t k = 1; k < found.size(); ++k)
    EXPECT_GT(found[k].exponent, 0.9);
}

TEST(SingularVertices,
     have_the_exponent_one_where_the_mesh_is_too_coarse_for_a_fit) {
  EXPECT_EQ(Square(6).singular(0.5).front().exponent, 1);
}

TEST(SingularVertices,
     are_the_corners_and_where_the_boundary_condition_changes) {
  Square square(8);
  EXPECT_EQ(square.singular(1).size(), 4u);
  // the bottom is in contact left of x = 1/2
  for (int e = 0; e < square.edges.count(); ++e) {
    const Vector2d a = square.mesh.vertices.col(square.edges.vertices(0, e));
    const bool at_bottom =
        square.edges.on_boundary(e) &&
        square.mesh.boundary_label[square.edges.boundary_index[e]] == bottom;
    if (at_bottom && a.x() < 0.5) square.contact_edge[e] = e;
  }
  const std::vector<SingularVertex> found = square.singular(1);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found[1].vertex, 4);
}

TEST(LocalRates, are_the_exponents_around_the_vertices_and_one_elsewhere) {
  const Square square(4);
  const VectorXd rates =
      local_rates(square.topology, {{0, 0.5}, {1, 0.7}, {24, 1.0}});
  int half = 0, seventh = 0;
  for (int t = 0; t < square.mesh.cell_count(); ++t) {
    bool at_0 = false, at_1 = false;
    for (int v : square.mesh.cells.col(t)) {
      at_0 = at_0 || v == 0;
      at_1 = at_1 || v == 1;
    }
    EXPECT_EQ(rates[t], at_0 ? 0.5 : at_1 ? 0.7 : 1.0);
    half += at_0;
    seventh += at_1 && !at_0;
  }
  EXPECT_EQ(half, 2);
  EXPECT_EQ(seventh, 2);
}

}  // namespace
}  // namespace ffcontact
