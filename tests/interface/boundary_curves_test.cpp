// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/boundary_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ffcontact/interface/boundary_chains.hpp"
#include "ffcontact/interface/pairing/facing_traces.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "support/arcs.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// n edges a label of a pin of radius 10 in a bore of radius 10.05 with m edges.
struct PinInBore {
  JoinedMesh joined;
  Edges edges;

  PinInBore(const std::vector<double>& pin, const std::vector<double>& bore)
      : joined(joined_mesh<2>({arc_body(pin, 10), hollow_body(bore, 10.05)})),
        edges(edges_of(joined.mesh)) {}
  /// How far gaps are off the clearance, by curves or by polygons.
  double off(const BoundaryCurves& curves) const {
    const Mesh& mesh = joined.mesh;
    const ContactLine line = contact_line(
        mesh, edges, {joined.label(0, bottom)}, BoundaryCurves(mesh, edges));
    const FacingTraces traces =
        facing_traces(mesh, edges, line, {joined.label(1, bottom)}, curves);
    double most = 0;
    for (const FacingPiece& piece : traces.pieces)
      for (const double gap : {piece.gap_begin, piece.gap_end})
        most = std::max(most, std::abs(gap - 0.05));
    return most;
  }
};

RC_GTEST_PROP(BoundaryCurves, have_the_gap_of_circles_at_any_vertices,
              (Random random)) {
  const Uniform step{1, 3};
  const auto angles = [&](int n, double half) {
    std::vector<double> all{0};
    for (int k = 0; k < n; ++k) all.push_back(all.back() + step(random));
    for (double& angle : all) angle = half * (2 * angle / all.back() - 1);
    return all;
  };
  const PinInBore two(angles(24, 0.8), angles(31, 0.9));
  const BoundaryCurves curves(two.joined.mesh, two.edges);
  RC_ASSERT(two.off(curves) < 1e-7);
  RC_ASSERT(two.off({}) > 1e-3);
}

TEST(BoundaryCurves, say_how_far_they_are_beside_their_edges) {
  const Mesh mesh = arc_body(even_angles(-0.8, 0.8, 16), 10);
  const Edges edges = edges_of(mesh);
  const auto labelled = [&](int label) {
    const std::vector<int> found = labelled_boundary(mesh, edges, {label});
    return VectorXi(Eigen::Map<const VectorXi>(found.data(), found.size()));
  };
  const BoundaryCurves curves(mesh, edges);
  const CurvedEdges arc = curved_edges(curves, labelled(bottom));
  EXPECT_EQ(arc.count, 16);
  EXPECT_NEAR(arc.largest_turn, 0.1, 1e-12);
  EXPECT_NEAR(arc.sagitta, 10 * (1 - std::cos(0.05)), 1e-9);
  EXPECT_EQ(curved_edges(curves, labelled(left)).count, 0);
  EXPECT_EQ(
      curved_edges(BoundaryCurves(mesh, edges, 0), labelled(bottom)).count, 0);
  EXPECT_EQ(
      curved_edges(BoundaryCurves(mesh, edges, 5.7), labelled(bottom)).count,
      0);
}

TEST(CorneredEdges, are_rows_of_like_corners) {
  const auto row = [](int n, double turn) {
    const Mesh mesh =
        arc_body(even_angles(-0.5 * n * turn, 0.5 * n * turn, n), 10);
    const Edges edges = edges_of(mesh);
    return cornered_edges(mesh, edges, labelled_boundary(mesh, edges, {bottom}),
                          0.53);
  };
  EXPECT_EQ(row(4, 0.7).count, 4);
  EXPECT_NEAR(row(4, 0.7).largest_turn, 0.7, 1e-12);
  EXPECT_EQ(row(4, 0.5).count, 1) << "a curve";
  EXPECT_EQ(row(3, 1.2).count, 1) << "sharper than a hexagon";
}

TEST(BoundaryChains, end_where_a_body_touches_itself) {
  Mesh mesh;  // two triangles with one vertex in common
  mesh.vertices.resize(2, 5);
  mesh.vertices << 0, 1, 1, -1, -1,  //
      0, -1, 1, 1, -1;
  mesh.cells.resize(3, 2);
  mesh.cells << 0, 0, 1, 3, 2, 4;
  mesh.boundary.resize(2, 6);
  mesh.boundary << 0, 1, 2, 0, 3, 4, 1, 2, 0, 3, 4, 0;
  mesh.boundary_label.setConstant(6, bottom);
  const Edges edges = edges_of(mesh);
  const auto chains =
      boundary_chains(mesh, edges, labelled_boundary(mesh, edges, {bottom}));
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].size(), 3u);
  EXPECT_EQ(chains[1].size(), 3u);
}

}  // namespace
}  // namespace ffcontact
