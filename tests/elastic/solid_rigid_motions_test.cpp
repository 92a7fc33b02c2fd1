// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <string>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The brick (0, 4) x (0, 2) x (0, 1) with vertex numbers 15 k + 5 j + i.
SolidMesh solid_block() { return brick({4, 2, 1}, {4, 2, 1}); }

std::vector<char> prescribed(const SolidMesh& mesh,
                             const std::vector<int>& dofs) {
  std::vector<char> marks(3 * mesh.vertex_count(), 0);
  for (int dof : dofs) marks[dof] = 1;
  return marks;
}

std::vector<int> all_at(const std::vector<int>& vertices) {
  std::vector<int> dofs;
  for (int v : vertices)
    for (int c = 0; c < 3; ++c) dofs.push_back(3 * v + c);
  return dofs;
}

Index free_motions(const SolidMesh& mesh, const std::vector<int>& dofs) {
  return free_rigid_motions(mesh, prescribed(mesh, dofs)).cols();
}

/// The only free motion in words, in the direction of the axes.
std::string free_solid_motion(const SolidMesh& mesh,
                              const std::vector<int>& dofs) {
  const MatrixXd motions = free_rigid_motions(mesh, prescribed(mesh, dofs));
  if (motions.cols() != 1) return std::to_string(motions.cols()) + " motions";
  return motion_in_words(mesh, motions.col(0) * (motions.sum() < 0 ? -1 : 1));
}

/// The motion shift + turn x (x - point) of the block in words.
std::string words(const Vector3d& shift,
                  const Vector3d& turn = Vector3d::Zero(),
                  const Vector3d& point = Vector3d::Zero(),
                  const SolidMesh& mesh = solid_block()) {
  return motion_in_words(mesh,
                         nodal_values(mesh, [&](const Vector3d& x) -> Vector3d {
                           return shift + turn.cross(x - point);
                         }));
}

TEST(SolidRigidMotions, are_six_for_each_part_that_nothing_holds) {
  EXPECT_EQ(free_motions(solid_block(), {}), 6);
  const SolidMesh two = joined(solid_block(), solid_block());
  EXPECT_EQ(free_motions(two, {}), 12);
  EXPECT_EQ(free_motions(two, all_at({0, 4, 10})), 6);
}

TEST(SolidRigidMotions, are_none_where_three_vertices_are_held) {
  EXPECT_EQ(free_motions(solid_block(), all_at({0, 4, 10})), 0);
}

TEST(SolidRigidMotions, a_ball_joint_leaves_three_and_a_symmetry_plane_too) {
  EXPECT_EQ(free_motions(solid_block(), all_at({7})), 3);
  std::vector<int> plane;
  for (int v = 0; v < 15; ++v) plane.push_back(3 * v + 2);
  EXPECT_EQ(free_motions(solid_block(), plane), 3);
}

TEST(SolidRigidMotions, two_held_vertices_leave_the_rotation_about_their_line) {
  EXPECT_EQ(free_solid_motion(solid_block(), all_at({4, 19})),
            "rotation about (0, 0, -1) through (4, 0, 0.5)");
  EXPECT_EQ(free_solid_motion(solid_block(), all_at({0, 4})),
            "rotation about (1, 0, 0) through (2, 0, 0)");
}

TEST(SolidRigidMotions, three_symmetry_planes_but_one_leave_a_translation) {
  std::vector<int> dofs;
  for (int v : {0, 4, 10, 14}) dofs.push_back(3 * v + 2);
  for (int v : {0, 4}) dofs.push_back(3 * v + 1);
  EXPECT_EQ(free_solid_motion(solid_block(), dofs),
            "translation along (1, 0, 0)");
}

TEST(SolidRigidMotions,
     of_a_single_tetrahedron_turning_about_its_edge_are_told) {
  SolidMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << Vector3d::Zero(), Matrix3d::Identity();
  mesh.vertices(0, 1) = 2;
  mesh.cells.resize(4, 1);
  mesh.cells << 0, 1, 2, 3;
  EXPECT_EQ(free_solid_motion(mesh, all_at({0, 3})),
            "rotation about (0, 0, 1) through (0, 0, 0.25)");
}

TEST(SolidRigidMotions, slanted_ones_are_told_by_direction_axis_and_pitch) {
  EXPECT_EQ(words({-0.3, 0.4, 0}), "translation along (-0.6, 0.8, 0)");
  EXPECT_EQ(words({0, 0, 0}, {0, 0.003, 0.004}, {2, 1, 0.5}),
            "rotation about (0, 0.6, 0.8) through (2, 1, 0.5)");
  EXPECT_EQ(words({0, 0, 0.05 / (2 * M_PI)}, {0, 0, 0.1}, {3, 0, 0}),
            "rotation about (0, 0, 1) through (3, 0, 0.5), 0.5 mm a turn");
  EXPECT_EQ(words({0, 0.2, 0}, {0, 0, 0.1}, {0, 0, 0}),
            "rotation about (0, 0, 1) through (-2, 0, 0.5)");
}

TEST(SolidRigidMotions, are_told_in_the_coordinates_of_who_made_the_mesh) {
  SolidMesh mesh = solid_block();
  mesh.origin = Vector3d(100, 200, 300);
  EXPECT_EQ(words({0, 0, 0}, {0, 0, -1}, {4, 0, 0}, mesh),
            "rotation about (0, 0, -1) through (104, 200, 300.5)");
}

TEST(SolidRigidMotions, of_the_second_part_are_told_where_it_is) {
  SolidMesh mesh = joined(solid_block(), solid_block());
  mesh.vertices.rightCols(30).row(0).array() += 10;
  std::vector<int> held = all_at({0, 4, 10});
  for (int dof : all_at({30, 45})) held.push_back(dof);
  EXPECT_EQ(free_solid_motion(mesh, held),
            "rotation about (0, 0, 1) through (10, 0, 0.5)");
}

RC_GTEST_PROP(SolidRigidMotions,
              strain_nothing_and_are_all_that_prescribed_dofs_leave,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  std::vector<int> dofs;
  for (int k = *rc::gen::inRange(0, 7); k > 0; --k)
    dofs.push_back(static_cast<int>(random() % (3 * mesh.vertex_count())));
  MatrixXd rows(dofs.size(), 6);  // of the six motions about the origin
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    const Vector3d axis = Vector3d::Unit(dofs[k] % 3),
                   x = mesh.vertices.col(dofs[k] / 3);
    rows.row(k) << axis.transpose(), x.cross(axis).transpose();
  }
  const auto rank_at = [&](double threshold) -> Index {
    if (dofs.empty()) return 0;
    return Eigen::JacobiSVD<MatrixXd>(rows).setThreshold(threshold).rank();
  };
  const Index rank = rank_at(1e-3);
  RC_PRE(rank == rank_at(1e-7));  // else it is a matter of taste
  const MatrixXd motions = free_rigid_motions(mesh, prescribed(mesh, dofs));
  RC_ASSERT(motions.cols() == 6 - rank);
  for (Index m = 0; m < motions.cols(); ++m) {
    RC_ASSERT(motions.col(m).cwiseAbs().maxCoeff() > 0.1);
    for (int t = 0; t < mesh.cell_count(); ++t)
      RC_ASSERT(strain(mesh, motions.col(m), t).norm() < 1e-11);
    for (int dof : dofs) RC_ASSERT(std::abs(motions(dof, m)) < 1e-11);
  }
}

}  // namespace
}  // namespace ffcontact
