// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/matching_faces.hpp"

#include "support/cut_solids.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The halves of a solid, `apart` along z.
SolidStack halves(double apart, Random& random) {
  const Vector3i cells(1 + random() % 2, 1 + random() % 3, 1 + random() % 2);
  std::vector<SolidMesh> pieces =
      CutSolid(cells, false, 0.15, random).pieces(random);
  pieces[1].vertices.row(2).array() -= apart;
  return {pieces, 0};
}

RC_GTEST_PROP(MatchingFaces, are_those_that_lie_on_each_other,
              (Random random)) {
  const double apart = *real(0, 0.5);
  const SolidStack stack = halves(apart, random);
  const auto& [mesh, faces, surface, law, A, b, neumann] = stack.problem;
  const std::vector<MatchingFace> matches =
      matching_faces(mesh, faces, surface);
  for (int m = 0; m < surface.face_count(); ++m) {
    RC_ASSERT(matches[m].face >= 0);
    const Vector3i own = faces.vertices.col(surface.face[m]),
                   opposite = faces.vertices.col(matches[m].face);
    for (int k = 0; k < 3; ++k) {
      const Vector3d off = mesh.vertices.col(own[k]) - Vector3d(0, 0, apart) -
                           mesh.vertices.col(opposite[matches[m].corner[k]]);
      RC_ASSERT(off.norm() < 1e-14);
    }
  }
}

/// A vertex of the lower half that is moved away: its faces match no longer.
RC_GTEST_PROP(MatchingFaces, are_not_those_that_are_moved, (Random random)) {
  const double by = std::pow(10.0, -*real(1, 9));
  SolidStack stack = halves(0, random);
  auto& [mesh, faces, surface, law, A, b, neumann] = stack.problem;
  const std::vector<MatchingFace> matches =
      matching_faces(mesh, faces, surface);
  const std::vector<int> below = vertices_on(mesh, stack.label(1, high_z));
  const int vertex = below[random() % below.size()];
  mesh.vertices(2, vertex) -= by;
  const ContactSurface moved =
      facing(mesh, faces, stack.label(0, low_z), stack.label(1, high_z))
          .surface;
  const std::vector<MatchingFace> left = matching_faces(mesh, faces, moved);
  for (int m = 0; m < surface.face_count(); ++m) {
    const bool is_at =
        (faces.vertices.col(matches[m].face).array() == vertex).any();
    RC_ASSERT(left[m].face == (is_at ? -1 : matches[m].face));
  }
}

TEST(MatchingFaces, are_none_of_other_meshes) {
  const SolidMesh upper = brick({2, 2, 1}, {3, 2, 1});
  for (const Vector3i& cells : {Vector3i(1, 2, 1), Vector3i(4, 4, 1)}) {
    SolidMesh lower = brick(cells, {3, 2, 1});
    lower.vertices.row(2).array() -= 1;
    const SolidStack stack({upper, lower}, 0);
    for (const MatchingFace& match : matching_faces(
             stack.problem.mesh, stack.problem.faces, stack.problem.surface))
      EXPECT_EQ(match.face, -1);
  }
}

/// Faces that face two bodies, as one behind another, or one body twice.
TEST(MatchingFaces, face_one_body_alone) {
  Random random(1);
  const SolidProblem problem = halves(0, random).problem;
  const ContactSurface twice =
      joined_contact<3>({problem.surface, problem.surface});
  for (const MatchingFace& match :
       matching_faces(problem.mesh, problem.faces, twice))
    EXPECT_EQ(match.face, -1);
}

/// A face on one of its size, but aside of it.
TEST(MatchingFaces, lie_straight_before_each_other) {
  SolidMesh upper;
  upper.vertices = MatrixXd::Zero(3, 4);
  upper.vertices.rightCols<3>().setIdentity();
  upper.cells = Vector4i(0, 1, 2, 3);
  upper = piece_of(upper, {0}, 0);
  for (double aside : {0.0, 0.1, 1e-6}) {
    SolidMesh lower = upper;
    lower.vertices.row(0).array() += aside;
    lower.vertices(2, 3) = -1;
    lower.cells = Vector4i(1, 0, 2, 3);
    for (int& label : lower.boundary_label)
      if (label == low_z) label = high_z;
    const SolidProblem problem = SolidStack({upper, lower}, 0).problem;
    const int found =
        matching_faces(problem.mesh, problem.faces, problem.surface)[0].face;
    EXPECT_EQ(found >= 0, aside == 0);
  }
}

TEST(MatchingFaces, are_none_on_a_rigid_foundation) {
  const SolidProblem problem(brick({1, 1, 1}, {1, 1, 1}));
  for (const MatchingFace& match :
       matching_faces(problem.mesh, problem.faces, problem.surface))
    EXPECT_EQ(match.face, -1);
}

}  // namespace
}  // namespace ffcontact
