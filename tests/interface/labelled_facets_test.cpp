// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/labelled_facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(LabelledFacets, are_those_of_their_labels_in_order) {
  const SolidMesh mesh = brick({3, 2, 1}, {3, 2, 1});
  const Facets<3> faces = facets_of(mesh);
  const std::vector<int> found = labelled_facets(mesh, faces, {high_z, low_x});
  EXPECT_EQ(found.size(), 2u * (3 * 2 + 2 * 1));
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  double area = 0;
  for (const int f : found) {
    const Matrix3d x = facet_points<3>(mesh, faces.vertices.col(f));
    EXPECT_TRUE((x.row(0).array() == 0).all() || (x.row(2).array() == 1).all());
    area += facet_measure(mesh, faces, f);
  }
  EXPECT_DOUBLE_EQ(area, 6 + 2);
  EXPECT_EQ(labelled_facets(mesh, faces, {low_y, low_y}).size(), 2u * 3);
}

/// A label on an edge inside the body alone.
TEST(LabelledFacets, inside_the_body_are_refused) {
  Mesh mesh = rectangle(2, 1, 2, 1);
  mesh.boundary.conservativeResize(2, 7);
  mesh.boundary_label.conservativeResize(7);
  mesh.boundary.col(6) << 1, 4;
  mesh.boundary_label[6] = 9;
  const Facets<2> facets = facets_of(mesh);
  const auto said = [&](const std::vector<int>& labels) {
    return refusal([&] { labelled_facets(mesh, facets, labels); });
  };
  EXPECT_EQ(said({bottom, top}), "accepted");
  EXPECT_TRUE(says(said({bottom, 9}), "label 9 is on edges inside the body"));
  EXPECT_EQ(said({bottom, 8}), "label 8 is on no boundary edge of the mesh");
}

}  // namespace
}  // namespace ffcontact
