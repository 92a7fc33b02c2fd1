// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/near_origin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Coordinates are of the size of the body. Their differences to the origin are exact
/// from its half to its double, and rounded by a digit at most below.
template <int dim>
void expect_near_origin(SimplexMesh<dim> mesh) {
  const SimplexMesh<dim> before = mesh;
  take_from_near_origin(mesh);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double size =
      (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff())
          .norm();
  RC_ASSERT(mesh.vertices.cwiseAbs().maxCoeff() <= 9 * size);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    for (int c = 0; c < dim; ++c) {
      const double x = before.vertices(c, v), origin = mesh.origin[c];
      const bool exact = 2 * std::abs(x) >= std::abs(origin);
      RC_ASSERT(std::abs(mesh.place(v)[c] - x) <=
                (exact ? 0 : epsilon * std::abs(x)));
    }
}

RC_GTEST_PROP(NearOrigin, coordinates_keep_their_digits, (Random random)) {
  const double scale = std::pow(10, *real(-3, 3)),
               far = std::pow(10, *real(0, 8));
  Mesh mesh = irregular(3, 2, 3, 2, random);
  mesh.vertices = (scale * mesh.vertices).colwise() +
                  Vector2d(far * random_vector(2, random));
  expect_near_origin(mesh);
  SolidMesh solid = irregular_solid(random);
  solid.vertices = (scale * solid.vertices).colwise() +
                   Vector3d(far * random_vector(3, random));
  expect_near_origin(solid);
}

TEST(NearOrigin, bodies_near_zero_keep_their_coordinates) {
  for (const double far : {0.0, 10.0, -17.0}) {
    Mesh mesh = rectangle(3, 4, 3, 4);
    mesh.vertices.array() += far;
    const Mesh before = mesh;
    take_from_near_origin(mesh);
    EXPECT_EQ(mesh.vertices, before.vertices) << far;
    EXPECT_EQ(mesh.origin, Vector2d::Zero()) << far;
  }
}

/// Of size 5: multiples of 64.
TEST(NearOrigin, is_a_multiple_of_a_power_of_two) {
  Mesh mesh = rectangle(3, 4, 3, 4);
  mesh.vertices.colwise() += Vector2d(1000, -31);
  take_from_near_origin(mesh);
  EXPECT_EQ(mesh.origin, Vector2d(1024, 0));
}

TEST(NearOrigin, of_meshes_without_size_is_zero) {
  Mesh mesh;
  take_from_near_origin(mesh);
  EXPECT_EQ(mesh.origin, Vector2d::Zero());
  mesh.vertices = Vector2d(3e9, 4);
  take_from_near_origin(mesh);
  EXPECT_EQ(mesh.origin, Vector2d::Zero());
}

}  // namespace
}  // namespace ffcontact
