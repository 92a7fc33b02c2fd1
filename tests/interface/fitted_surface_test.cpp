// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/fitted_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/interface/pairing/facing_polygons.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A brick bent about the y axis: its side low_z becomes part of a cylinder of this
/// radius, of 0.1 rad a unit of x, with its axis above it; high_z of a hollow one.
SolidMesh bent(SolidMesh mesh, double radius) {
  for (auto x : mesh.vertices.colwise()) {
    const double r = radius - x[2], angle = 0.1 * x[0];
    x << r * std::sin(angle), x[1], -r * std::cos(angle);
  }
  return mesh;
}

SolidMesh placed(SolidMesh mesh, const Vector3d& by) {
  mesh.vertices.colwise() += by;
  return mesh;
}

SolidMesh upper_brick() {
  return placed(brick({8, 2, 1}, {8, 2, 1}), {-4, 0, 0});
}
SolidMesh lower_brick() {
  return placed(brick({7, 3, 1}, {10, 2, 1}), {-5, 0, -1});
}

std::optional<NodeOfFace> fitted(const SolidMesh& upper,
                                 const SolidMesh& lower) {
  const JoinedSolids joined = joined_mesh<3>({upper, lower});
  const Facets<3> faces = facets_of(joined.mesh);
  const ContactSurface surface = contact_surface(joined.mesh, faces, {low_z});
  return node_of_fitted_surface(
      joined.mesh, faces, surface,
      facing_polygons(joined.mesh, faces, surface, {joined.label(1, high_z)}));
}

TEST(FittedSurface, is_a_pin_in_its_bore_and_no_pin_on_a_plane_or_a_pin) {
  const auto pin = fitted(bent(upper_brick(), 10), bent(lower_brick(), 10.05));
  ASSERT_TRUE(pin);
  SolidMesh flat = placed(lower_brick(), {0, 0, -10.05});
  EXPECT_FALSE(fitted(bent(upper_brick(), 10), flat));
  // one in a groove of 2.5 times its radius
  EXPECT_FALSE(fitted(bent(upper_brick(), 10),
                      placed(bent(lower_brick(), 25), {0, 0, 14.9})));
  // one on the back of another
  SolidMesh back = bent(upper_brick(), 10);
  back.vertices.row(2).array() = -back.vertices.row(2).array() - 20;
  back.cells.row(0).swap(back.cells.row(1));
  for (int& label : back.boundary_label)
    label = label == low_z ? high_z : label == high_z ? low_z : label;
  EXPECT_FALSE(fitted(bent(upper_brick(), 10), back));
  // flat ones
  EXPECT_FALSE(fitted(upper_brick(), lower_brick()));
}

TEST(FittedSurface, is_any_curved_one_on_a_rigid_foundation_of_its_shape) {
  const auto fits = [](const SolidMesh& mesh) {
    const Facets<3> faces = facets_of(mesh);
    return node_of_fitted_surface(mesh, faces,
                                  contact_surface(mesh, faces, {low_z}), {});
  };
  EXPECT_TRUE(fits(bent(upper_brick(), 10)));
  EXPECT_FALSE(fits(upper_brick()));
}

}  // namespace
}  // namespace ffcontact
