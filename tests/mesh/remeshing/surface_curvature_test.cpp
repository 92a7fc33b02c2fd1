// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/surface_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/nested_solids.hpp"
#include "support/pi.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(SurfaceCurvature, is_that_of_cylinders_and_none_of_planes) {
  constexpr int n = 8;
  constexpr double radius = 3;
  SolidMesh mesh = brick({n, 2, 2}, {pi / 2, 1, 2});  // a quarter of a tube
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vector3d x = mesh.vertices.col(v);
    const double r = radius + x.y();
    mesh.vertices.col(v) << r * std::sin(x.x()), r * std::cos(x.x()), -x.z();
  }
  mesh.cells.row(2).swap(mesh.cells.row(3));
  if (signed_volume(mesh, 0) < 0) mesh.cells.row(2).swap(mesh.cells.row(3));
  const Facets<3> faces = facets_of(mesh);
  const SurfaceModel model =
      surface_model(mesh, faces, VectorXi::Zero(mesh.cell_count()), pi / 6);
  const VectorXd curvature = surface_curvature(mesh, faces, model);
  const double turn = pi / 2 / n, chord = 2 * std::sin(turn / 2);
  int inner = 0, outer = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vector3d x = mesh.vertices.col(v);
    const double r = x.head<2>().norm();
    if (x.x() < 1e-9 || x.y() < 1e-9) continue;  // the ends
    if (std::abs(r - radius) < 1e-9) {
      EXPECT_NEAR(curvature[v], turn / (radius * chord), 1e-12);
      ++inner;
    } else if (std::abs(r - radius - 1) < 1e-9) {
      EXPECT_NEAR(curvature[v], turn / ((radius + 1) * chord), 1e-12);
      ++outer;
    } else {
      EXPECT_EQ(curvature[v], 0);
    }
  }
  EXPECT_EQ(inner, 3 * (n - 1));
  EXPECT_EQ(outer, 3 * (n - 1));
}

/// Faces turn by arccos(1/3) at each edge, and their height above it is sqrt(3/2) times
/// the radius.
TEST(SurfaceCurvature, of_an_octahedron_is_that_of_its_edges) {
  constexpr double radius = 2;
  SolidMesh mesh;  // around its centre, vertex 6
  mesh.vertices = Matrix3Xd::Zero(3, 7);
  for (int c = 0; c < 3; ++c) {
    mesh.vertices(c, 2 * c) = radius;
    mesh.vertices(c, 2 * c + 1) = -radius;
  }
  mesh.cells.resize(4, 8);
  for (int t = 0; t < 8; ++t) {
    const bool odd = ((t ^ (t >> 1) ^ (t >> 2)) & 1) != 0;
    const int x = t & 1, y = 2 + (t >> 1 & 1), z = 4 + (t >> 2);
    mesh.cells.col(t) << 6, x, odd ? z : y, odd ? y : z;
  }
  add_boundary(mesh);
  mesh.boundary_label.setConstant(1);
  const Facets<3> faces = facets_of(mesh);
  const SurfaceModel model =
      surface_model(mesh, faces, VectorXi::Zero(mesh.cell_count()), pi / 2);
  const VectorXd curvature = surface_curvature(mesh, faces, model);
  const double height = radius * std::sqrt(1.5);
  for (int v = 0; v < 6; ++v)
    EXPECT_NEAR(curvature[v], std::acos(1.0 / 3) / height, 1e-14);
  EXPECT_EQ(curvature[6], 0);
}

}  // namespace
}  // namespace ffcontact
