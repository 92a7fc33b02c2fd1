// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/mesh/remeshing/moved_onto_parts.hpp"
#include "support/meshes.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double corner = pi / 6;

/// A block on (0, 4) x (0, 3) whose lower side is bent downwards to an arc.
Mesh block_on_arc(int n, double radius) {
  Mesh mesh = rectangle(n, n, 4, 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double x = mesh.vertices(0, v) - 2, y = mesh.vertices(1, v);
    mesh.vertices(1, v) -= (1 - y / 3) * std::sqrt(radius * radius - x * x);
  }
  return mesh;
}

int count_of(const std::vector<BoundaryPart>& parts, int label, bool straight) {
  return static_cast<int>(
      std::count_if(parts.begin(), parts.end(), [&](const BoundaryPart& part) {
        return part.label == label && part.straight() == straight;
      }));
}

/// The vertices of one label, without its ends, moved at random.
Mesh disturbed(Mesh mesh, int label, double by, std::mt19937& random) {
  std::map<int, int> degree;
  for (int b = 0; b < mesh.boundary.cols(); ++b)
    if (mesh.boundary_label[b] == label)
      for (int v : mesh.boundary.col(b)) ++degree[v];
  const Uniform shift{-by, by};
  for (const auto& [vertex, edges] : degree)
    if (edges == 2)
      mesh.vertices.col(vertex) += Vector2d(shift(random), shift(random));
  return mesh;
}

RC_GTEST_PROP(BoundaryParts, of_a_rectangle_are_its_sides_whatever_the_labels,
              (Random random)) {
  Mesh mesh = rotated(irregular(4, 3, 4, 3, random), 0.3);
  RC_ASSERT(boundary_parts(mesh, corner).size() == 4);
  mesh.boundary_label.setConstant(7);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  RC_ASSERT(parts.size() == 4);
  for (const BoundaryPart& part : parts)
    RC_ASSERT(part.straight() && part.label == 7);
}

TEST(BoundaryParts, are_lines_and_curves) {
  const std::vector<BoundaryPart> parts =
      boundary_parts(block_on_arc(12, 6), corner);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(count_of(parts, bottom, false), 1);
  for (int side : {right, top, left}) EXPECT_EQ(count_of(parts, side, true), 1);
}

TEST(BoundaryParts, of_a_closed_curve_are_one) {
  Mesh mesh = rectangle(12, 12, 2, 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Vector2d x = mesh.vertices.col(v) - Vector2d(1, 1);
    if (x.norm() > 0)
      mesh.vertices.col(v) = x * x.cwiseAbs().maxCoeff() / x.norm();
    if (x.norm() == 0) mesh.vertices.col(v).setZero();
  }
  mesh.boundary_label.setConstant(1);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_FALSE(parts[0].straight());
  EXPECT_EQ(parts[0].curve->tangents.col(0), parts[0].curve->tangents.col(48));
  EXPECT_EQ(parts[0].columns.size(), 48u);
}

TEST(BoundaryParts, split_where_the_label_changes_and_where_a_line_branches) {
  Mesh mesh = rectangle(4, 4, 4, 4);
  for (int b = 0; b < 2; ++b) mesh.boundary_label[b] = 9;
  const int columns = static_cast<int>(mesh.boundary.cols());
  mesh.boundary.conservativeResize(Eigen::NoChange, columns + 1);
  mesh.boundary.col(columns) << 23, 18;  // from the top inwards
  mesh.boundary_label.conservativeResize(columns + 1);
  mesh.boundary_label[columns] = top;
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  EXPECT_EQ(count_of(parts, bottom, true), 1);
  EXPECT_EQ(count_of(parts, 9, true), 1);
  EXPECT_EQ(count_of(parts, top, true), 3);
}

TEST(BoundaryParts,
     of_a_curve_end_where_the_label_changes_and_know_the_whole_curve) {
  Mesh mesh = block_on_arc(12, 6);
  for (int b = 0; b < 2; ++b) mesh.boundary_label[b] = 9;
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  EXPECT_EQ(count_of(parts, 9, false), 1);
  EXPECT_EQ(count_of(parts, bottom, false), 1);
  for (const BoundaryPart& part : parts)
    if (!part.straight()) {
      EXPECT_EQ(part.curve->pieces(), 12);
    }
}

TEST(BoundaryParts, labels_are_their_own) {
  const Mesh mesh = rectangle(3, 2, 3, 2);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  const VectorXi labels = labelled_by_parts(mesh, parts);
  for (int b = 0; b < labels.size(); ++b) {
    EXPECT_GT(labels[b], left);
    for (int other = 0; other < b; ++other)
      EXPECT_EQ(labels[b] == labels[other],
                mesh.boundary_label[b] == mesh.boundary_label[other]);
  }
}

TEST(SmallestCorner, is_between_the_turns_of_curves_and_corners) {
  const auto angle = [](const Mesh& mesh) {
    return smallest_corner(mesh, boundary_parts(mesh, corner), corner);
  };
  EXPECT_LT(angle(rectangle(3, 3, 3, 3)), corner);
  const double turn = 2 * std::asin(2 / 6.0) / 12;
  EXPECT_GT(angle(block_on_arc(12, 6)), 1.2 * turn);
  Mesh bent = rectangle(4, 2, 4, 2);
  for (int v = 0; v < 3; ++v) bent.vertices(1, v) = 0.2 * (v - 2);
  EXPECT_LT(angle(bent), std::atan(0.2));
  EXPECT_GT(angle(bent), pi / 180);
}

RC_GTEST_PROP(MovedOntoParts, puts_vertices_back_on_straight_lines,
              (Random random)) {
  const Mesh mesh = rotated(rectangle(4, 3, 4, 3), 0.3);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  Mesh fine = rotated(rectangle(12, 9, 4, 3), 0.3);
  Mesh labelled = mesh;
  labelled.boundary_label = labelled_by_parts(mesh, parts);
  for (int b = 0; b < fine.boundary.cols(); ++b)
    for (int c = 0; c < mesh.boundary.cols(); ++c)
      if (mesh.boundary_label[c] == fine.boundary_label[b]) {
        fine.boundary_label[b] = labelled.boundary_label[c];
        break;
      }
  const Mesh moved = moved_onto_parts(
      disturbed(fine, part_label(mesh, 0), 0.1, random), mesh, parts);
  const Mesh back = rotated(moved, -0.3);
  double area = 0;
  for (int t = 0; t < moved.cell_count(); ++t) {
    RC_ASSERT(signed_area(moved, t) > 0);
    area += signed_area(moved, t);
  }
  RC_ASSERT(std::abs(area - 12) < 1e-12 * 12);
  for (int b = 0; b < fine.boundary.cols(); ++b)
    for (int v : fine.boundary.col(b)) {
      const Vector2d x = back.vertices.col(v);
      const double off = std::min({std::abs(x.x()), std::abs(x.x() - 4),
                                   std::abs(x.y()), std::abs(x.y() - 3)});
      RC_ASSERT(off < 1e-14);
    }
}

TEST(MovedOntoParts,
     puts_vertices_of_chords_on_the_circle_and_corners_on_corners) {
  const Mesh mesh = block_on_arc(12, 6);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  Mesh labelled = mesh;
  labelled.boundary_label = labelled_by_parts(mesh, parts);
  Mesh fine = labelled;
  for (int level = 0; level < 3; ++level)
    fine = refined(fine, triangles_near(fine, {2, -6}, 10));
  fine.vertices.col(0) +=
      Vector2d(1e-7, 1e-7);  // a corner: its label is the first
  const Mesh moved = moved_onto_parts(fine, mesh, parts);
  EXPECT_EQ(moved.vertices.col(0), mesh.vertices.col(0));
  double before = 0, after = 0;
  for (int b = 0; b < fine.boundary.cols(); ++b)
    if (fine.boundary_label[b] == labelled.boundary_label[0])
      for (int v : fine.boundary.col(b)) {
        before = std::max(
            before,
            std::abs((fine.vertices.col(v) - Vector2d(2, 0)).norm() - 6));
        after = std::max(
            after,
            std::abs((moved.vertices.col(v) - Vector2d(2, 0)).norm() - 6));
      }
  EXPECT_GT(before, 1e-3);
  EXPECT_LT(after, 1e-7);
}

TEST(MovedOntoParts, lets_inner_vertices_give_way) {
  const Mesh mesh = block_on_arc(6, 3);
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  Mesh fine = mesh;
  fine.boundary_label = labelled_by_parts(mesh, parts);
  // above, but for a hair below
  for (int i = 1; i < 6; ++i)
    fine.vertices(1, 7 + i) = fine.vertices(1, i) - 0.001;
  for (int i = 1; i < 6; ++i) fine.vertices(1, i) -= 0.3;
  const Mesh moved = moved_onto_parts(fine, mesh, parts);
  for (int t = 0; t < moved.cell_count(); ++t)
    EXPECT_GT(signed_area(moved, t), 0);
}

TEST(MovedOntoParts, refuses_triangles_that_turn_over) {
  const Mesh mesh = rectangle(4, 1, 4, 1);
  Mesh fine = mesh;
  const std::vector<BoundaryPart> parts = boundary_parts(mesh, corner);
  fine.boundary_label = labelled_by_parts(mesh, parts);
  // positive triangles, but the wrong order along the side
  fine.vertices.col(1) << 1.5, -1;
  fine.vertices.col(2) << 1.4, -3;
  EXPECT_TRUE(says(refusal([&] { moved_onto_parts(fine, mesh, parts); }),
                   "turns over"));
}

}  // namespace
}  // namespace ffcontact
