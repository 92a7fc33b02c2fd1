// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/facing_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/facing.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A row of four edges of length 1 from (0, 1), on a body from `begin` to `end`.
Facing overhanging(double begin, double end) {
  return Facing(shifted(rectangle(4, 1, 4, 1), {0, 1}),
                shifted(rectangle(1, 1, end - begin, 1), {begin, 0}));
}

TEST(FacingLine, ends_where_the_opposite_body_ends) {
  const ContactLine line = overhanging(0.75, 3.375).line;
  Matrix2Xd part(2, 4);
  part << 0.75, 0, 0, 0, 1, 1, 1, 0.375;
  EXPECT_LT((line.part - part).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((line.length - Vector4d(0.25, 1, 1, 0.375)).cwiseAbs().maxCoeff(),
            1e-14);
  EXPECT_EQ(line.abscissa, Vector3d(1, 2, 3));
  Matrix2Xi nodes(2, 4);
  nodes << 0, 0, 1, 2, 0, 1, 2, 2;
  EXPECT_EQ(line.edge_node, nodes);
  EXPECT_NEAR(contact_mass(line).sum(), 2.625, 1e-14);
}

TEST(FacingLine, drops_edges_that_face_nothing) {
  const ContactLine line = overhanging(1, 3).line;
  EXPECT_EQ(line.part.size(), 0);
  EXPECT_EQ(line.abscissa, Vector3d(1, 2, 3));
}

/// Between two vertices, or on two parts of edges, multipliers must hold the moment of a
/// body on one edge: two nodes at least.
TEST(FacingLine, on_few_edges_has_nodes_at_its_ends) {
  const ContactLine within = overhanging(1.25, 1.5).line,
                    about = overhanging(1.75, 2.125).line;
  EXPECT_EQ(within.abscissa, Vector2d(1.25, 1.5));
  EXPECT_EQ(about.abscissa, Vector2d(1.75, 2));
  EXPECT_TRUE(is_constant_on(about, 1));
}

/// With matching meshes, too: a jump against two vertices at once would count both.
TEST(FacingLine, faces_both_bodies_in_front_of_a_joint) {
  Mesh lower =
      joined(rectangle(2, 1, 2, 1), shifted(rectangle(2, 1, 2, 1), {2, 0}));
  lower.boundary_label.tail(6).array() -= 10;
  const ContactLine line =
      Facing(shifted(rectangle(4, 1, 4, 1), {0, 1}), lower).line;
  ASSERT_EQ(line.node_count(), 5);
  EXPECT_FALSE(line.matches());
  for (int i = 0; i < line.node_count(); ++i)
    EXPECT_NEAR(line.opposite.row(i).sum(), 1, 1e-14) << i;
}

TEST(FacingLine, ends_at_a_vertex_that_the_opposite_end_all_but_meets) {
  for (const double off : {-5e-5, 5e-5}) {
    const ContactLine line = overhanging(1 + off, 3 + off).line;
    EXPECT_EQ(line.part.size(), 0) << off;
    ASSERT_EQ(line.edge_count(), 2) << off;
    EXPECT_EQ(line.pieces.front().opposite_begin, 1) << off;
    EXPECT_EQ(line.pieces.back().opposite_end, 0) << off;
  }
}

/// Abscissae of the vertices at y = 3, ascending.
std::vector<double> places_on_line(const Mesh& mesh) {
  std::vector<double> places;
  for (const auto x : mesh.vertices.colwise())
    if (std::abs(x.y() - 3) < 1e-9) places.push_back(x.x());
  std::sort(places.begin(), places.end());
  return places;
}

/// Is an end of one body as near to a vertex of the other as is taken for that vertex?
bool all_but_meet(const Mesh& one, const Mesh& other) {
  const std::vector<double> places = places_on_line(one);
  for (double x : places_on_line(other))
    for (double end : {places.front(), places.back()})
      if (std::abs(end - x) < 1e-2) return true;
  return false;
}

/// Either line on the other, each going on beyond the other somewhere.
Facing random_overhang(std::mt19937& random) {
  while (true) {
    const int upper = 1 + static_cast<int>(random() % 7),
              lower = 1 + static_cast<int>(random() % 7);
    const double x = -3.5 + 0.01 * static_cast<double>(random() % 900);
    const Mesh above =
                   shifted(with_random_rows(upper, 2, 4, 2, random), {x, 3}),
               below = with_random_rows(lower, 2, 6, 3, random);
    if (!all_but_meet(above, below) && !all_but_meet(below, above))
      return Facing(above, below);
  }
}

RC_GTEST_PROP(FacingLine, has_no_jump_where_both_traces_move_linearly,
              (Random random)) {
  const Facing two = random_overhang(random);
  const Vector3d a = random_vector(3, random), b = random_vector(3, random);
  const VectorXd u = nodal_values(two.joined.mesh, [&](const Vector2d& x) {
    return Vector2d(a[0] + a[1] * x.x() + a[2] * x.y(),
                    b[0] + b[1] * x.x() + b[2] * x.y());
  });
  RC_ASSERT(contact_components(two.line, u).cwiseAbs().maxCoeff() < 1e-10);
}

RC_GTEST_PROP(FacingLine,
              integrals_of_the_jump_are_exact_where_it_ends_within_edges,
              (Random random)) {
  const Facing two = random_overhang(random);
  const ContactLine& line = two.line;
  const VectorXd u = random_vector(two.joined.mesh.vertices.cols(), random);
  const auto on_edge = [&](int edge, double s) {
    return (1 - s) * u[two.edges.vertices(0, edge)] +
           s * u[two.edges.vertices(1, edge)];
  };
  VectorXd exact = VectorXd::Zero(line.node_count());
  for (const FacingPiece& piece : line.pieces)
    for (int k = 0; k < 3; ++k) {
      const int e = piece.contact_edge, edge = line.edge[e];
      const double x = piece.begin + k / 2.0 * (piece.end - piece.begin);
      const double y = piece.opposite_begin +
                       k / 2.0 * (piece.opposite_end - piece.opposite_begin);
      const double length =
          edge_vector(two.joined.mesh, two.edges, edge).norm() *
          (piece.end - piece.begin);
      const double value = length * (k == 1 ? 4 : 1) / 6 *
                           (on_edge(edge, x) - on_edge(piece.opposite_edge, y));
      exact[line.edge_node(0, e)] += (1 - line.share(e, x)) * value;
      exact[line.edge_node(1, e)] += line.share(e, x) * value;
    }
  VectorXd at_nodes(line.node_count());
  for (int i = 0; i < line.node_count(); ++i) at_nodes[i] = u[line.vertex[i]];
  RC_ASSERT((contact_mass(line) * (at_nodes - line.opposite * u) - exact)
                .cwiseAbs()
                .maxCoeff() < 1e-12);
}

RC_GTEST_PROP(ExchangedLine, is_that_of_the_opposite_body, (Random random)) {
  const Facing two = random_overhang(random);
  const std::vector<int> upper{two.joined.label(0, bottom)},
      lower{two.joined.label(1, top)};
  const ContactLine other = contact_line(two.joined.mesh, two.edges, lower);
  const ContactLine expected =
      facing_line(two.joined.mesh, two.edges, other,
                  facing_traces(two.joined.mesh, two.edges, other, upper));
  const auto exchanged =
      exchanged_line(two.joined.mesh, two.edges, two.line, lower);
  RC_ASSERT(exchanged.has_value());
  RC_ASSERT(exchanged->vertex == expected.vertex &&
            exchanged->edge_node == expected.edge_node);
  RC_ASSERT(exchanged->edge == expected.edge &&
            exchanged->part.cols() == expected.part.cols());
  RC_ASSERT((exchanged->normal - expected.normal).cwiseAbs().maxCoeff() <
            1e-12);
  RC_ASSERT((exchanged->abscissa - expected.abscissa).cwiseAbs().maxCoeff() <
            1e-9);
  RC_ASSERT((exchanged->length - expected.length).cwiseAbs().maxCoeff() < 1e-9);
  RC_ASSERT(
      MatrixXd(exchanged->opposite - expected.opposite).cwiseAbs().maxCoeff() <
      1e-7);
  RC_ASSERT(facing_gap(*exchanged).isZero(0));
}

TEST(ExchangedLine, keeps_the_gap_and_turns_directions_round) {
  Mesh lower = rectangle(3, 1, 6, 3);
  for (int v = 0; v < lower.vertex_count(); ++v)
    if (lower.vertices(1, v) == 3)
      lower.vertices(1, v) -= 0.1 * std::abs(lower.vertices(0, v) - 2);
  const Facing two(shifted(rectangle(4, 1, 4, 2), {1, 3}), lower);
  const auto exchanged = exchanged_line(two.joined.mesh, two.edges, two.line,
                                        {two.joined.label(1, top)});
  ASSERT_TRUE(exchanged.has_value());
  // one node a vertex, though the lower side turns
  ASSERT_EQ(exchanged->node_count(), 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(exchanged->normal.col(i), Vector2d(0, 1));
    const Vector2d x = two.joined.mesh.place(exchanged->vertex[i]);
    EXPECT_NEAR(facing_gap(*exchanged)[i], 0.1 * std::abs(x.x() - 2), 1e-14);
  }
}

TEST(ExchangedLine, is_none_where_two_parts_face_one_place) {
  Mesh hollow = shifted(rectangle(4, 2, 4, 2), {0, 2});
  for (int v = 0; v < hollow.vertex_count(); ++v)
    if (hollow.vertices(1, v) == 2)
      hollow.vertices(1, v) += 0.3 * (2 - std::abs(hollow.vertices(0, v) - 2));
  const Facing two(hollow, shifted(rectangle(7, 2, 6, 1.9), {-1, 0}));
  EXPECT_FALSE(exchanged_line(two.joined.mesh, two.edges, two.line,
                              {two.joined.label(1, top)})
                   .has_value());
}

RC_GTEST_PROP(FacingLine, integrals_of_the_opposite_displacement_are_exact,
              (Random random)) {
  const Facing two = random_rows(random);
  const VectorXd u = random_vector(two.joined.mesh.vertices.cols(), random);
  // int psi_i u by Simpson's rule on every piece, exact for products of linear functions
  VectorXd exact = VectorXd::Zero(two.line.node_count());
  for (const FacingPiece& piece : two.line.pieces)
    for (int k = 0; k < 3; ++k) {
      const double x = piece.begin + k / 2.0 * (piece.end - piece.begin);
      const double y = piece.opposite_begin +
                       k / 2.0 * (piece.opposite_end - piece.opposite_begin);
      const double weight = two.line.length[piece.contact_edge] *
                            (piece.end - piece.begin) * (k == 1 ? 4 : 1) / 6;
      const double value =
          (1 - y) * u[two.edges.vertices(0, piece.opposite_edge)] +
          y * u[two.edges.vertices(1, piece.opposite_edge)];
      exact[two.line.edge_node(0, piece.contact_edge)] +=
          weight * (1 - x) * value;
      exact[two.line.edge_node(1, piece.contact_edge)] += weight * x * value;
    }
  RC_ASSERT((contact_mass(two.line) * (two.line.opposite * u) - exact)
                .cwiseAbs()
                .maxCoeff() < 1e-13);
}

RC_GTEST_PROP(FacingLine, has_no_jump_where_both_bodies_move_alike,
              (Random random)) {
  const Facing two = random_rows(random);
  const Vector2d by = random_vector(2, random);
  const VectorXd u =
      nodal_values(two.joined.mesh, [&](const Vector2d&) { return by; });
  RC_ASSERT(contact_components(two.line, u).cwiseAbs().maxCoeff() < 1e-12);
}

}  // namespace
}  // namespace ffcontact
