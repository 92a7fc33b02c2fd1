// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/rigid_motions.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/hooke.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The rectangle (0, 4) x (0, 2) with vertex numbers 5 j + i.
Mesh block() { return rectangle(4, 2, 4, 2); }

std::vector<char> prescribed(const Mesh& mesh, const std::vector<int>& dofs) {
  std::vector<char> marks(2 * mesh.vertex_count(), 0);
  for (int dof : dofs) marks[dof] = 1;
  return marks;
}

/// The only free motion in words, in the direction of the axes.
std::string free_motion(const Mesh& mesh, const std::vector<int>& dofs) {
  const MatrixXd motions = free_rigid_motions(mesh, prescribed(mesh, dofs));
  if (motions.cols() != 1) return std::to_string(motions.cols()) + " motions";
  return motion_in_words(mesh, motions.col(0) * (motions.sum() < 0 ? -1 : 1));
}

TEST(RigidMotions, a_clamped_body_has_none) {
  EXPECT_EQ(
      free_rigid_motions(block(), prescribed(block(), {0, 1, 2, 3})).cols(), 0);
}

TEST(RigidMotions, a_symmetry_line_leaves_the_translation_along_it) {
  EXPECT_EQ(free_motion(block(), {0, 10, 20}), "translation along (0, 1)");
  EXPECT_EQ(free_motion(block(), {1, 3, 5, 7, 9}), "translation along (1, 0)");
}

TEST(RigidMotions, a_pin_leaves_the_rotation_about_it) {
  EXPECT_EQ(free_motion(block(), {14, 15}), "rotation about (2, 1)");
  EXPECT_EQ(free_motion(block(), {28, 29}), "rotation about (4, 2)");
}

TEST(RigidMotions,
     two_rollers_leave_the_rotation_about_the_crossing_of_their_normals) {
  EXPECT_EQ(free_motion(block(), {0, 2 * 4 + 1}), "rotation about (4, 0)");
}

TEST(RigidMotions, a_free_body_has_three) {
  EXPECT_EQ(free_rigid_motions(block(), prescribed(block(), {})).cols(), 3);
}

TEST(RigidMotions, of_two_parts_are_counted_for_each) {
  const Mesh mesh = joined(block(), block());
  EXPECT_EQ(free_rigid_motions(mesh, prescribed(mesh, {})).cols(), 6);
  EXPECT_EQ(free_rigid_motions(mesh, prescribed(mesh, {0, 1, 2, 3})).cols(), 3);
}

TEST(RigidMotions, of_the_second_part_are_told_in_words) {
  Mesh mesh = joined(block(), block());
  mesh.vertices.rightCols(15).row(0).array() += 10;
  EXPECT_EQ(free_motion(mesh, {0, 1, 2, 3, 30, 31}), "rotation about (10, 0)");
}

TEST(RigidMotions, a_slanted_translation_is_told_by_its_direction) {
  const VectorXd motion = nodal_values(
      block(), [](const Vector2d&) { return Vector2d(-0.3, 0.4); });
  EXPECT_EQ(motion_in_words(block(), motion), "translation along (-0.6, 0.8)");
}

RC_GTEST_PROP(RigidMotions, strain_nothing_and_vanish_on_prescribed_dofs,
              (Random random)) {
  const Mesh mesh = rotated(irregular(4, 2, 4, 2, random), 0.4);
  std::vector<int> dofs;
  for (int k = *rc::gen::inRange(0, 3); k > 0; --k)
    dofs.push_back(random() % (2 * mesh.vertex_count()));
  const std::vector<char> marks = prescribed(mesh, dofs);
  const MatrixXd motions = free_rigid_motions(mesh, marks);
  for (Index m = 0; m < motions.cols(); ++m) {
    RC_ASSERT(motions.col(m).cwiseAbs().maxCoeff() > 0.1);
    for (int t = 0; t < mesh.cell_count(); ++t)
      RC_ASSERT(strain(mesh, motions.col(m), t).norm() < 1e-11);
    for (std::size_t dof = 0; dof < marks.size(); ++dof)
      RC_ASSERT((!marks[dof] || std::abs(motions(dof, m)) < 1e-12));
  }
}

RC_GTEST_PROP(RigidMotions, are_as_many_as_prescribed_dofs_leave,
              (Random random)) {
  const Mesh mesh = irregular(4, 2, 4, 2, random);
  const int v = random() % mesh.vertex_count(),
            w = (v + 1) % mesh.vertex_count();
  const auto count = [&](const std::vector<int>& dofs) {
    return free_rigid_motions(mesh, prescribed(mesh, dofs)).cols();
  };
  RC_ASSERT(count({2 * v}) == 2);
  RC_ASSERT(count({2 * v, 2 * v + 1}) == 1);
  RC_ASSERT(count({2 * v, 2 * v + 1, 2 * w, 2 * w + 1}) == 0);
}

}  // namespace
}  // namespace ffcontact
