// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/contact_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/interface/curve_directions.hpp"
#include "support/meshes.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

ContactLine line_of(const Mesh& mesh, const std::vector<int>& labels) {
  return contact_line(mesh, edges_of(mesh), labels);
}

ContactLine curved_line_of(const Mesh& mesh, const std::vector<int>& labels) {
  const Edges edges = edges_of(mesh);
  return contact_line(mesh, edges, labels, BoundaryCurves(mesh, edges));
}

std::string refusal_of(const std::vector<int>& labels) {
  return refusal([&] { line_of(rectangle(2, 2, 2, 2), labels); });
}

Vector2d position(const Mesh& mesh, const ContactLine& line, int node) {
  return mesh.vertices.col(line.vertex[node]);
}

RC_GTEST_PROP(ContactLine, edges_run_along_the_tangent, (Random random)) {
  const Mesh mesh = rotated(irregular(4, 3, 4, 3, random), 0.7);
  const ContactLine line = line_of(mesh, {bottom, left});
  for (int e = 0; e < line.edge_count(); ++e) {
    const int i = line.edge_node(0, e), j = line.edge_node(1, e);
    const Vector2d along = position(mesh, line, j) - position(mesh, line, i);
    RC_ASSERT((along - line.length[e] * line.edge_tangent(e)).norm() < 1e-14);
    RC_ASSERT(std::abs(line.abscissa[j] - line.abscissa[i] - line.length[e]) <
              1e-14);
    RC_ASSERT((line.tangent(j) - line.edge_tangent(e)).norm() < 1e-14);
  }
}

RC_GTEST_PROP(ContactLine, bottom_nodes_go_from_left_to_right,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const ContactLine line = line_of(mesh, {bottom});
  RC_ASSERT(line.node_count() == line.edge_count() + 1);
  for (int i = 0; i < line.node_count(); ++i) {
    RC_ASSERT(std::abs(line.abscissa[i] - mesh.vertices(0, line.vertex[i])) <
              1e-14);
    RC_ASSERT(line.normal.col(i) == Vector2d(0, -1));
    RC_ASSERT((i == 0 || line.abscissa[i] > line.abscissa[i - 1]));
  }
}

RC_GTEST_PROP(ContactLine, mass_has_the_row_sums_of_half_the_neighbouring_edges,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const ContactLine line = line_of(mesh, {bottom, right});
  const MatrixXd mass = contact_mass(line);
  VectorXd expected = VectorXd::Zero(line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int end = 0; end < 2; ++end)
      expected[line.edge_node(end, e)] += line.length[e] / 2;
  RC_ASSERT((mass.rowwise().sum() - expected).norm() < 1e-14);
  RC_ASSERT(std::abs(mass.sum() - 7) < 7e-14);
  RC_ASSERT(mass == mass.transpose());
}

RC_GTEST_PROP(ContactLine, mass_integrates_products_of_linear_functions,
              (Random random)) {
  const ContactLine line = line_of(irregular(4, 3, 4, 3, random), {bottom});
  const VectorXd s = line.abscissa;  // int s^2 ds over (0, 4)
  RC_ASSERT(std::abs(s.dot(contact_mass(line) * s) - 64.0 / 3) < 1e-12);
}

TEST(ContactLine, is_straight_within_the_rounding_of_its_coordinates) {
  for (const double unit : {1e-8, 1e-6}) {
    Mesh mesh = rotated(rectangle(16, 2, 1, 1), 0.3);
    mesh.vertices = (mesh.vertices / unit).array().round().matrix() * unit;
    const ContactLine line = line_of(mesh, {bottom, right});
    EXPECT_EQ(line.node_count(), 17 + 3);
    for (int i = 0; i < 17; ++i) {
      EXPECT_EQ(line.normal.col(i), line.normal.col(0));
      EXPECT_LT(
          (line.normal.col(i) - Vector2d(std::sin(0.3), -std::cos(0.3))).norm(),
          2 * unit);
    }
  }
}

TEST(ContactLine, that_is_closed_starts_at_a_corner) {
  Mesh mesh = rotated(rectangle(4, 4, 4, 4), 0.3);
  VectorXi swapped = VectorXi::LinSpaced(25, 0, 24);
  std::swap(swapped[0],
            swapped[2]);  // vertex 0 is in the middle of the lower side
  for (int& v : mesh.cells.reshaped()) v = swapped[v];
  for (int& v : mesh.boundary.reshaped()) v = swapped[v];
  mesh.vertices.col(0).swap(mesh.vertices.col(2));
  mesh.boundary_label.setConstant(bottom);
  const ContactLine line = line_of(mesh, {bottom});
  EXPECT_EQ(line.node_count(), 16 + 4);
  EXPECT_NE(line.normal.col(line.node_count() - 1), line.normal.col(0));
}

TEST(ContactLine, a_corner_is_two_nodes_that_no_mass_couples) {
  const Mesh mesh = rectangle(2, 2, 2, 2);
  const ContactLine line = line_of(mesh, {left, bottom});
  ASSERT_EQ(line.node_count(), 6);
  EXPECT_EQ(line.vertex, (VectorXi(6) << 6, 3, 0, 0, 1, 2).finished());
  EXPECT_EQ(line.normal.col(2), Vector2d(-1, 0));
  EXPECT_EQ(line.normal.col(3), Vector2d(0, -1));
  EXPECT_EQ(line.abscissa[2], line.abscissa[3]);
  EXPECT_EQ(MatrixXd(contact_mass(line)).topRightCorner(3, 3),
            Matrix3d::Zero());
}

RC_GTEST_PROP(ContactLine,
              the_whole_boundary_is_closed_with_four_doubled_corners,
              (Random random)) {
  const Mesh mesh = irregular(3, 3, 3, 3, random);
  const ContactLine line = line_of(mesh, {left, bottom, right, top});
  RC_ASSERT(line.edge_count() == mesh.boundary.cols());
  RC_ASSERT(line.node_count() == line.edge_count() + 4);
  const VectorXd rows = MatrixXd(contact_mass(line)).rowwise().sum();
  RC_ASSERT(std::abs(rows.sum() - 12) < 1e-13);
  RC_ASSERT(rows.minCoeff() > 0);
}

TEST(ContactLine, separate_sides_come_one_after_the_other) {
  const ContactLine line = line_of(rectangle(3, 2, 3, 2), {top, bottom});
  EXPECT_EQ(line.node_count(), 8);
  EXPECT_EQ(line.edge_count(), 6);
  EXPECT_EQ(MatrixXd(contact_mass(line)).topRightCorner(4, 4),
            Matrix4d::Zero());
}

TEST(ContactLine, every_edge_is_a_line_of_its_own_where_the_boundary_bends) {
  Mesh mesh = rectangle(4, 1, 4, 1);
  for (int i = 0; i <= 4; ++i) mesh.vertices(1, i) = -0.05 * i * (4 - i);
  const ContactLine line = line_of(mesh, {bottom});
  EXPECT_EQ(line.node_count(), 8);
  for (int e = 0; e < 4; ++e)
    EXPECT_EQ(line.edge_node.col(e), Vector2i(2 * e, 2 * e + 1));
}

RC_GTEST_PROP(ContactLine, components_are_projections_on_n_and_t,
              (Random random)) {
  const Mesh mesh = rotated(irregular(3, 2, 3, 2, random), 1.1);
  const ContactLine line = line_of(mesh, {bottom, left});
  const VectorXd field = random_vector(2 * mesh.vertices.cols(), random);
  const Matrix2Xd components = contact_components(line, field);
  for (int i = 0; i < line.node_count(); ++i) {
    const Vector2d back = components(0, i) * line.normal.col(i) +
                          components(1, i) * line.tangent(i);
    RC_ASSERT((back - field.segment<2>(2 * line.vertex[i])).norm() < 1e-14);
  }
}

/// A chain of points as the lower side of a fan of triangles around a point above it; the
/// other sides have the label top.
Mesh fan_on(const Matrix2Xd& chain, const Vector2d& above) {
  const int n = static_cast<int>(chain.cols()) - 1;
  Mesh mesh;
  mesh.vertices.resize(2, n + 2);
  mesh.vertices << chain, above;
  mesh.cells.resize(3, n);
  mesh.boundary.resize(2, n + 2);
  mesh.boundary_label.setConstant(n + 2, top);
  for (int i = 0; i < n; ++i) {
    mesh.cells.col(i) << i, i + 1, n + 1;
    mesh.boundary.col(i) << i, i + 1;
    mesh.boundary_label[i] = bottom;
  }
  mesh.boundary.col(n) << n, n + 1;
  mesh.boundary.col(n + 1) << n + 1, 0;
  return mesh;
}

/// Points of an arc of radius 1 around (0, 1), from its lowest point on by `step` each.
Matrix2Xd arc(int edges, double step) {
  Matrix2Xd points(2, edges + 1);
  for (int k = 0; k <= edges; ++k)
    points.col(k) << std::sin(k * step), 1 - std::cos(k * step);
  return points;
}

TEST(CurvedContactLine,
     a_smooth_curve_has_one_node_a_vertex_and_the_normals_of_the_circle) {
  const ContactLine line =
      curved_line_of(fan_on(arc(10, 0.1), {0.2, 2}), {bottom});
  ASSERT_EQ(line.node_count(), 11);
  for (int i = 0; i < 11; ++i)
    EXPECT_LT(
        (line.normal.col(i) - Vector2d(std::sin(0.1 * i), -std::cos(0.1 * i)))
            .norm(),
        1e-14);
}

TEST(CurvedContactLine, few_edges_and_sharp_turns_are_a_polygon) {
  const auto nodes = [](int edges, double step) {
    const Vector2d above(0.5 * edges * step, 3);
    return curved_line_of(fan_on(arc(edges, step), above), {bottom})
        .node_count();
  };
  EXPECT_EQ(nodes(3, 0.1), 4);
  EXPECT_EQ(nodes(2, 0.1), 4);  // two lines with two nodes where they meet
  EXPECT_EQ(nodes(5, 0.53), 6);
  EXPECT_EQ(nodes(5, 0.54), 10);
}

TEST(CurvedContactLine, has_the_normals_of_the_curve_beyond_its_label) {
  Mesh mesh = fan_on(arc(10, 0.1), {0.2, 2});
  for (int k = 0; k < 10; ++k)
    mesh.boundary_label[k] = k < 3 || k > 4 ? left : bottom;
  const ContactLine line = curved_line_of(mesh, {bottom});
  ASSERT_EQ(line.node_count(), 3);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT((line.normal.col(i) -
               Vector2d(std::sin(0.1 * (3 + i)), -std::cos(0.1 * (3 + i))))
                  .norm(),
              1e-14);
}

TEST(CurvedContactLine,
     a_curve_that_goes_on_from_a_straight_line_has_its_normal_where_they_meet) {
  Matrix2Xd chain(2, 11);
  chain << Vector2d(-0.9, 0), Vector2d(-0.6, 0), Vector2d(-0.3, 0), arc(7, 0.1);
  const ContactLine line = curved_line_of(fan_on(chain, {0.2, 2}), {bottom});
  ASSERT_EQ(line.node_count(), 11);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(line.normal.col(i), Vector2d(0, -1));
  EXPECT_GT(line.normal(0, 4), 0.09);
  chain.leftCols(3).row(1).array() += 0.05;  // a corner of 9 degrees
  chain(1, 1) = 2.0 / 3 * chain(1, 0);
  chain(1, 2) = 1.0 / 3 * chain(1, 0);
  EXPECT_EQ(curved_line_of(fan_on(chain, {0.2, 2}), {bottom}).node_count(), 12);
}

TEST(CurvedContactLine, around_a_disc_is_closed_without_a_corner) {
  Mesh mesh;
  const int n = 36;
  mesh.vertices.resize(2, n + 1);
  mesh.vertices.col(n).setZero();
  mesh.cells.resize(3, n);
  mesh.boundary.resize(2, n);
  mesh.boundary_label.setConstant(n, bottom);
  for (int i = 0; i < n; ++i) {
    mesh.vertices.col(i) << std::cos(2 * pi * i / n), std::sin(2 * pi * i / n);
    mesh.cells.col(i) << i, (i + 1) % n, n;
    mesh.boundary.col(i) << i, (i + 1) % n;
  }
  const ContactLine line = curved_line_of(mesh, {bottom});
  ASSERT_EQ(line.node_count(), n);
  for (int i = 0; i < n; ++i)
    EXPECT_LT((line.normal.col(i) - position(mesh, line, i)).norm(), 1e-13);
}

/// The lower half of a regular polygon of 2 n sides around the origin, radius 1.
Mesh half_disc(int n) {
  Matrix2Xd chain(2, n + 1);
  for (int i = 0; i <= n; ++i)
    chain.col(i) << -std::cos(pi * i / n), -std::sin(pi * i / n);
  return fan_on(chain, {0, 0});
}

TEST(SmoothContactLine,
     of_a_polygon_has_one_node_a_vertex_and_the_normals_of_the_circle) {
  const Mesh mesh = half_disc(8);
  const ContactLine line = smooth_contact_line(mesh, edges_of(mesh), {bottom});
  ASSERT_EQ(line.node_count(), 9);
  for (int i = 1; i < 8; ++i)
    EXPECT_LT((line.normal.col(i) - position(mesh, line, i)).norm(), 1e-14);
  EXPECT_NEAR(MatrixXd(contact_mass(line)).sum(), 16 * std::sin(pi / 16),
              1e-14);
}

TEST(SmoothContactLine, around_a_whole_body_ends_at_its_first_node) {
  const Mesh mesh = rectangle(2, 1, 2, 1);
  const ContactLine line =
      smooth_contact_line(mesh, edges_of(mesh), {bottom, right, top, left});
  EXPECT_EQ(line.node_count(), 6);
  EXPECT_EQ(line.edge_count(), 6);
  EXPECT_EQ(line.edge_node(1, 5), line.edge_node(0, 0));
}

TEST(AlongDirections, takes_given_directions_in_place_of_the_normals) {
  const Mesh mesh = half_disc(8);
  const Edges edges = edges_of(mesh);
  const ContactLine smooth = smooth_contact_line(mesh, edges, {bottom});
  const Matrix2Xd down = Vector2d(0, -2).replicate(1, 9);
  const ContactLine line = along_directions(mesh, edges, smooth, down);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(line.normal.col(i), Vector2d(0, -1));
  EXPECT_EQ(line.length, smooth.length);
}

TEST(AlongDirections, refuses_a_direction_into_the_body_naming_its_vertex) {
  const Mesh mesh = half_disc(8);
  const Edges edges = edges_of(mesh);
  const ContactLine smooth = smooth_contact_line(mesh, edges, {bottom});
  Matrix2Xd direction = smooth.normal;
  direction.col(4) << 0, 1;
  const auto refusal_with = [&](const Matrix2Xd& d) {
    return refusal([&] { along_directions(mesh, edges, smooth, d); });
  };
  EXPECT_TRUE(says(refusal_with(direction),
                   "the contact direction (0, 1) at vertex 4 ("));
  direction.col(4).setZero();
  EXPECT_TRUE(says(refusal_with(direction), "does not point out of the body"));
  EXPECT_EQ(refusal_with(direction.leftCols(3)),
            "contact directions has 3 values where 9 are needed");
}

TEST(ContactLine, refuses_a_label_that_is_nowhere) {
  EXPECT_EQ(refusal_of({bottom, 17}),
            "label 17 is on no boundary edge of the mesh");
}

TEST(ContactLine, refuses_an_empty_list_of_labels) {
  EXPECT_EQ(refusal_of({}), "no contact label is given");
}

TEST(ContactLine, refuses_a_label_that_is_only_inside) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  mesh.boundary.conservativeResize(Eigen::NoChange, 7);
  mesh.boundary.col(6) << 1, 4;
  mesh.boundary_label.conservativeResize(7);
  mesh.boundary_label[6] = 8;
  EXPECT_TRUE(says(refusal([&] { line_of(mesh, {8}); }),
                   "label 8 is on edges inside the body alone"));
}

TEST(ContactLine, a_label_given_twice_counts_once) {
  EXPECT_EQ(refusal_of({bottom, bottom}), "accepted");
}

}  // namespace
}  // namespace ffcontact
