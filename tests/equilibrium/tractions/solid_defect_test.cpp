// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/solid_defect.hpp"

#include <gtest/gtest.h>

#include "support/loaded_solid.hpp"
#include "support/tetrahedra.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(SolidDefect, sees_every_spoilt_number, (Random random)) {
  const TetrahedronCorners x = random_tetrahedron(random);
  SolidLoads loads = balanced_solid_loads(x, random);
  SolidStress stress = composite_stress(x, loads.on_faces, loads.in_body);
  const auto defect = [&] {
    return tetrahedron_defect(x, stress, loads.on_faces, loads.in_body)
        .largest();
  };
  RC_ASSERT(defect() < 1e-10 * stress.cwiseAbs().maxCoeff());
  stress.reshaped()[*rc::gen::inRange(0, 96)] += 1e-3;
  RC_ASSERT(defect() > 1e-6);
}

RC_GTEST_PROP(SolidDefect, sees_other_loads, (Random random)) {
  const TetrahedronCorners x = random_tetrahedron(random);
  SolidLoads loads = balanced_solid_loads(x, random);
  const SolidStress stress = composite_stress(x, loads.on_faces, loads.in_body);
  SolidLoads spoilt = loads;
  spoilt.on_faces.reshaped()[*rc::gen::inRange(0, 36)] += 1e-3;
  RC_ASSERT(
      tetrahedron_defect(x, stress, spoilt.on_faces, spoilt.in_body).jump >
      1e-4);
  spoilt = loads;
  spoilt.in_body.reshaped()[*rc::gen::inRange(0, 12)] += 1e-3;
  RC_ASSERT(tetrahedron_defect(x, stress, spoilt.on_faces, spoilt.in_body)
                .divergence > 1e-4);
}

TEST(SolidDefect, boundary_counts_known_components_alone) {
  const SolidMesh mesh = brick({1, 1, 1}, {1, 1, 1});
  const Facets<3> faces = facets_of(mesh);
  std::vector<char> prescribed(24, 0);
  for (int v : vertices_on(mesh, low_x)) prescribed[3 * v + 1] = 1;
  const FaceTractions boundary =
      given_tractions(mesh, faces, prescribed, FaceMoments::Zero(9, 12));
  FaceMoments moments = boundary.moments;
  const int face = [&] {
    for (int f = 0;; ++f)
      if (faces.on_boundary(f) &&
          mesh.boundary_label[faces.boundary_index[f]] == low_x)
        return f;
  }();
  moments.col(face).segment<3>(3).setConstant(1);
  // moments (0, 1, 0) of a component on an area of 1/2: 12 / A (-1/4, 3/4, -1/4)
  EXPECT_NEAR(boundary_defect(mesh, faces, boundary, moments), 18, 1e-13);
  EXPECT_NEAR(largest_traction(mesh, faces, moments), 18, 1e-13);
  moments.col(face) << 0, 0, 0, 0, 1, 0, 0, 0, 0;
  EXPECT_EQ(boundary_defect(mesh, faces, boundary, moments), 0);
}

}  // namespace
}  // namespace ffcontact
