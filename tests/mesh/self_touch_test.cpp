// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/self_touch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/mesh/straight_runs.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two triangles; vertex 3 of the second is beside the side 1-2 of the first, at this
/// place along it and this far from it.
Mesh two_triangles(double place, double apart, double turn) {
  Mesh mesh;
  mesh.vertices.resize(2, 6);
  mesh.vertices << 0, 4, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0;
  const Vector2d normal(0.6, 0.8);
  const Vector2d tip = (1 - place) * mesh.vertices.col(1) +
                       place * mesh.vertices.col(2) + apart * normal;
  mesh.vertices.col(3) = tip;
  mesh.vertices.col(4) = tip + Vector2d(3, 1);
  mesh.vertices.col(5) = tip + Vector2d(1, 3);
  mesh.vertices = Eigen::Rotation2Dd(turn).toRotationMatrix() * mesh.vertices;
  mesh.cells.resize(3, 2);
  mesh.cells << 0, 3, 1, 4, 2, 5;
  mesh.boundary.resize(2, 6);
  mesh.boundary << 0, 1, 2, 3, 4, 5, 1, 2, 0, 4, 5, 3;
  mesh.boundary_label.setConstant(6, 1);
  return mesh;
}

RC_GTEST_PROP(SelfTouch, is_a_vertex_on_an_edge_that_is_not_its_own, ()) {
  const double place = *real(0.01, 0.99), turn = *real(-3, 3);
  const double least = 4e-9 * extent(two_triangles(place, 0, turn).vertices);
  const auto touch = [&](double apart) {
    return self_touch(two_triangles(place, apart, turn));
  };
  RC_ASSERT(touch(0) == 3);
  RC_ASSERT(touch(0.9 * least) == 3);
  RC_ASSERT(touch(-0.9 * least) == 3);
  RC_ASSERT(!touch(1.1 * least));
  RC_ASSERT(!touch(0.1));
}

RC_GTEST_PROP(SelfTouch, is_not_on_the_line_beyond_an_edge, ()) {
  const double turn = *real(-3, 3);
  RC_ASSERT(!self_touch(two_triangles(-0.1, 0, turn)));
  RC_ASSERT(!self_touch(two_triangles(1.1, 0, turn)));
  RC_ASSERT(self_touch(two_triangles(1, 0, turn)).has_value());  // at its end
}

/// As before, of an edge whose line the sorting of vertices does not tell from it.
TEST(SelfTouch, is_not_beyond_an_edge_that_is_normal_to_the_sorting) {
  const double turn = std::atan2(0.5878, 0.8090) - std::atan2(0.8, 0.6);
  EXPECT_FALSE(self_touch(two_triangles(-0.1, 0, turn)));
  EXPECT_FALSE(self_touch(two_triangles(1.1, 0, turn)));
  EXPECT_EQ(self_touch(two_triangles(0.1, 0, turn)), 3);
}

}  // namespace
}  // namespace ffcontact
