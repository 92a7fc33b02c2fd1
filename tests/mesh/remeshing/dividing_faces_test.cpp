// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/remeshing/dividing_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// 7 below z = 1, 9 above.
VectorXi layers(const SolidMesh& mesh) {
  return VectorXi::NullaryExpr(mesh.cell_count(), [&](Index t) {
    const auto x = mesh.vertices(Eigen::all, mesh.cells.col(t));
    return x.row(2).mean() < 1 ? 7 : 9;
  });
}

RC_GTEST_PROP(DividingFaces, are_the_boundary_and_those_between_regions,
              (Random random)) {
  const SolidMesh mesh = shuffled(brick({3, 2, 2}, {3, 2, 2}), random);
  const Facets<3> faces = facets_of(mesh);
  const DividingFaces dividing = dividing_faces(mesh, faces, layers(mesh));
  RC_ASSERT(dividing.part_count() == 2);
  RC_ASSERT(dividing.region[0] + dividing.region[1] == 16);
  RC_ASSERT(std::is_sorted(dividing.face.begin(), dividing.face.end()));
  RC_ASSERT(dividing.count() == mesh.boundary.cols() + 2 * 3 * 2);
  double volume = 0;  // a third of the flux of x
  for (int k = 0; k < dividing.count(); ++k) {
    const Vector3i v = faces.vertices.col(dividing.face[k]);
    const Vector3d normal = facet_vector(facet_points(mesh, v));
    const int from = dividing.parts(0, k), to = dividing.parts(1, k);
    RC_ASSERT((dividing.boundary[k] < 0) == (to >= 0));
    RC_ASSERT(from >= 0 && from != to);
    if (to >= 0)  // upwards out of the lower layer
      RC_ASSERT((normal.z() > 0) == (dividing.region[from] == 7));
    if (dividing.region[from] == 7)
      volume += normal.dot(mesh.vertices.col(v[0])) / 3;
    if (to >= 0 && dividing.region[to] == 7)
      volume -= normal.dot(mesh.vertices.col(v[0])) / 3;
  }
  RC_ASSERT(std::abs(volume - 6) < 1e-13);
}

/// The brick, with a label on the face inside it between the first two cells that share
/// one at z = 1 or, within a region, elsewhere.
SolidMesh with_inner_label(const SolidMesh& mesh, bool between_layers) {
  const Facets<3> faces = facets_of(mesh);
  for (int f = 0; f < faces.count(); ++f) {
    const Matrix3d x = facet_points<3>(mesh, faces.vertices.col(f));
    const bool flat = (x.row(2).array() == 1).all();
    if (faces.on_boundary(f) || flat != between_layers) continue;
    SolidMesh result = mesh;
    result.boundary.conservativeResize(3, mesh.boundary.cols() + 1);
    result.boundary_label.conservativeResize(mesh.boundary.cols() + 1);
    result.boundary.rightCols<1>() = faces.vertices.col(f);
    result.boundary_label.tail<1>()[0] = 42;
    return result;
  }
  return mesh;
}

TEST(DividingFaces, inside_a_part_are_refused_by_their_label) {
  const SolidMesh solid = brick({3, 2, 2}, {3, 2, 2});
  const auto said = [](const SolidMesh& mesh) {
    return refusal(
        [&] { dividing_faces(mesh, facets_of(mesh), layers(mesh)); });
  };
  EXPECT_TRUE(says(said(with_inner_label(solid, false)), "has the label 42"));
  EXPECT_EQ(said(with_inner_label(solid, true)), "accepted");
  EXPECT_NE(refusal([&] {
              dividing_faces(solid, facets_of(solid), VectorXi::Zero(3));
            }),
            "accepted");
}

}  // namespace
}  // namespace ffcontact
