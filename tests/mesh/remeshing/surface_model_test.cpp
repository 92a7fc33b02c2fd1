// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/surface_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ffcontact/base/packed.hpp"
#include "support/pi.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

SurfaceModel model_of(const SolidMesh& mesh, const VectorXi& regions) {
  return surface_model(mesh, facets_of(mesh), regions, pi / 6);
}
SurfaceModel model_of(const SolidMesh& mesh) {
  return model_of(mesh, VectorXi::Zero(mesh.cell_count()));
}

/// A cube mapped to a ball of radius 1.
SolidMesh ball(int n) {
  SolidMesh mesh = brick({n, n, n}, {2, 2, 2});
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Array3d x = mesh.vertices.col(v).array() - 1, s = x * x;
    mesh.vertices.col(v) << x[0] * std::sqrt(1 - s[1] / 2 - s[2] / 2 +
                                             s[1] * s[2] / 3),
        x[1] * std::sqrt(1 - s[2] / 2 - s[0] / 2 + s[2] * s[0] / 3),
        x[2] * std::sqrt(1 - s[0] / 2 - s[1] / 2 + s[0] * s[1] / 3);
  }
  return mesh;
}

RC_GTEST_PROP(SurfaceModel,
              of_a_brick_is_its_sides_edges_and_corners_whatever_the_labels,
              (Random random)) {
  SolidMesh mesh = moved(brick({4, 3, 3}, {4, 3, 3}), 1, 0.15, random);
  const Matrix3d turn =
      Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  mesh.vertices = (turn * mesh.vertices).eval();
  for (const bool one_label : {false, true}) {
    if (one_label) mesh.boundary_label.setConstant(7);
    const SurfaceModel model = model_of(mesh);
    RC_ASSERT(model.dividing.part_count() == 1);
    RC_ASSERT(model.patches.surface_count() == 6);
    RC_ASSERT(model.patches.patch_count() == 6);
    RC_ASSERT(std::all_of(model.patches.flat.begin(), model.patches.flat.end(),
                          [](char flat) { return flat == 1; }));
    RC_ASSERT(model.curves.curves.size() == 12);
    RC_ASSERT(model.curves.corners.size() == 8);
  }
}

TEST(SurfaceModel, parts_a_body_between_its_regions) {
  const SolidMesh mesh = brick({4, 2, 2}, {4, 2, 2});
  VectorXi regions(mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    regions[t] =
        mesh.vertices(Eigen::all, mesh.cells.col(t)).row(0).mean() > 3 ? 5 : 4;
  const SurfaceModel model = model_of(mesh, regions);
  ASSERT_EQ(model.dividing.part_count(), 2);
  EXPECT_EQ(model.dividing.region, (std::vector<int>{4, 5}));
  // four sides are cut in two, and the face between
  EXPECT_EQ(model.patches.surface_count(), 11);
  EXPECT_EQ(model.curves.corners.size(), 12);
  EXPECT_EQ(model.curves.curves.size(), 20);
}

TEST(SurfaceModel, refuses_a_label_inside_that_parts_nothing) {
  SolidMesh mesh = brick({2, 2, 2}, {2, 2, 2});
  const Facets<3> faces = facets_of(mesh);
  for (int f = 0; f < faces.count(); ++f)
    if (!faces.on_boundary(f)) {
      const Index last = mesh.boundary.cols();
      mesh.boundary.conservativeResize(3, last + 1);
      mesh.boundary.col(last) = faces.vertices.col(f);
      mesh.boundary_label.conservativeResize(last + 1);
      mesh.boundary_label[last] = 33;
      break;
    }
  EXPECT_EQ(
      refusal([&] { model_of(mesh); }),
      "a face inside the body has the label 33 and does not part it in "
      "two: such faces cannot be meshed anew, remove them from the boundary");
}

TEST(SurfaceModel, cuts_a_ball_into_patches_with_a_rim) {
  SolidMesh mesh = ball(4);
  mesh.boundary_label.setConstant(1);
  const SurfaceModel model = model_of(mesh);
  EXPECT_EQ(model.patches.surface_count(), 1);
  EXPECT_EQ(model.patches.patch_count(), 2);
  EXPECT_EQ(model.patches.flat[0], 0);
  for (const PatchCurve& curve : model.curves.curves)
    EXPECT_FALSE(curve.is_rim);
}

TEST(SurfaceModel, of_a_ball_of_six_labels_has_their_curves) {
  const SurfaceModel model = model_of(ball(4));
  EXPECT_EQ(model.patches.surface_count(), 6);
  EXPECT_EQ(model.curves.curves.size(), 12);
  EXPECT_EQ(model.curves.corners.size(), 8);
  EXPECT_EQ(model.patches.sheet, std::vector<int>(6, 0));
  for (const PatchCurve& curve : model.curves.curves) {
    EXPECT_TRUE(curve.is_rim && curve.is_label_line);
    EXPECT_EQ(curve.vertices.size(), 5);
  }
}

TEST(SurfaceModel, takes_a_single_face_for_no_plane_where_its_surface_goes_on) {
  SolidMesh mesh = ball(4);
  mesh.boundary_label.setConstant(1);
  mesh.boundary_label[0] = 2;
  const SurfaceModel model = model_of(mesh);
  EXPECT_EQ(model.patches.surface_count(), 2);
  EXPECT_EQ(model.patches.flat, Flags({0, 0}));
  SolidMesh box = brick({1, 1, 1}, {1, 1, 1});
  for (Index e = 0; e < box.boundary.cols(); ++e)
    box.boundary_label[e] = static_cast<int>(e);
  EXPECT_EQ(model_of(box).patches.flat, Flags(12, 1));
}

TEST(SurfaceModel, has_edges_between_planes_whatever_their_angle) {
  SolidMesh roof = brick({4, 4, 2}, {4, 4, 2});
  for (auto x : roof.vertices.colwise())
    x.z() *= 1 - 0.02 * std::abs(x.x() - 2);
  roof.boundary_label.setConstant(1);
  const SurfaceModel model = model_of(roof);
  EXPECT_EQ(model.patches.surface_count(), 7);
  EXPECT_EQ(model.curves.curves.size(), 15);
}

TEST(SurfaceModel, cuts_handles) {
  // a frame of eight cubes, two of whose upper sides have their own label
  SolidMesh frame = brick({3, 3, 1}, {3, 3, 1});
  std::vector<Vector4i> kept;
  for (const auto& cell : frame.cells.colwise()) {
    const Vector3d x =
        frame.vertices(Eigen::all, Vector4i(cell)).rowwise().mean();
    if (x.x() < 1 || x.x() > 2 || x.y() < 1 || x.y() > 2)
      kept.emplace_back(cell);
  }
  frame.cells = packed(kept);
  add_boundary(frame);
  for (Index f = 0; f < frame.boundary.cols(); ++f) {
    const Vector3d x =
        frame.vertices(Eigen::all, Vector3i(frame.boundary.col(f)))
            .rowwise()
            .mean();
    const bool of_a_corner =
        x.z() == 1 && x.y() < 1 && (x.x() < 1 || x.x() > 2);
    frame.boundary_label[f] = of_a_corner ? 2 : 1;
  }
  constexpr double corner = 2;  // right angles are smooth
  const SurfaceModel model = surface_model(
      frame, facets_of(frame), VectorXi::Zero(frame.cell_count()), corner);
  EXPECT_EQ(model.patches.surface_count(), 3);
  EXPECT_GT(model.patches.patch_count(), 3);
}

}  // namespace
}  // namespace ffcontact
