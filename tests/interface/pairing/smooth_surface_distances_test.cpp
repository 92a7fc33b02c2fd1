// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/pairing/smooth_surface_distances.hpp"

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

/// A part of a pin of radius 9.9 in one of a bore of radius 10.
struct PinInBore {
  JoinedSolids joined;
  Facets<3> faces;
  ContactSurface pin, bore;
  std::vector<FacingPolygon> polygons;

  explicit PinInBore(int cells)
      : joined(joined_mesh<3>(
            {bent(placed(brick({cells, 2, 1}, {8, 2, 1}), {-4, 0, 0}), 9.9),
             bent(placed(brick({cells + 1, 3, 1}, {10, 2, 1}), {-5, 0, -1}),
                  10)})),
        faces(facets_of(joined.mesh)),
        pin(contact_surface(joined.mesh, faces, {joined.label(0, low_z)})),
        bore(contact_surface(joined.mesh, faces, {joined.label(1, high_z)})),
        polygons(facing_polygons(joined.mesh, faces, pin,
                                 {joined.label(1, high_z)})) {}

  /// The largest difference of distances from the clearance.
  double off() const {
    double largest = 0;
    for (const FacingPolygon& polygon : polygons)
      largest =
          std::max(largest, (polygon.distance.array() - 0.1).abs().maxCoeff());
    return largest;
  }
};

TEST(SmoothDistances, are_those_between_the_surfaces) {
  double last = 0;
  for (const int cells : {6, 12, 24}) {
    PinInBore pair(cells);
    const double flat = pair.off();
    smooth_distances(pair.joined.mesh, pair.faces, pair.pin, pair.bore,
                     pair.polygons);
    EXPECT_LT(pair.off(), 0.15 * flat);
    EXPECT_TRUE(last == 0 || pair.off() < 0.4 * last)
        << pair.off() << " " << last << " " << flat;
    last = pair.off();
  }
}

TEST(SmoothDistances, of_flat_faces_stay) {
  PinInBore pair(6);
  for (ContactSurface* surface : {&pair.pin, &pair.bore})
    surface->normal.colwise() = Vector3d(0, 0, 1);
  const double flat = pair.off();
  smooth_distances(pair.joined.mesh, pair.faces, pair.pin, pair.bore,
                   pair.polygons);
  EXPECT_EQ(pair.off(), flat);
  EXPECT_EQ(largest_sagitta(pair.joined.mesh, pair.faces, pair.pin), 0);
}

/// R (1 - cos(angle/2)) of a chord.
TEST(SmoothDistances, sagitta_is_that_of_the_chords) {
  const PinInBore pair(8);
  EXPECT_NEAR(largest_sagitta(pair.joined.mesh, pair.faces, pair.pin),
              9.9 * (1 - std::cos(0.05)), 4e-4);
}

}  // namespace
}  // namespace ffcontact
