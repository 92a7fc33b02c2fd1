// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/facing_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/estimate/error/facing_error.hpp"
#include "support/facing_contact.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// All faces of a brick that stands on another one, fewer of one that stands beside it.
RC_GTEST_PROP(FacingFaces, are_those_that_face_with_all_of_their_area,
              (Random random)) {
  const FacingContact whole({0, 0, -1}, 0.5, random),
      beside({0.7, 0.3, -1}, 0.5, random);
  RC_ASSERT(count_of(whole.contact) == whole.surface().face_count());
  for (const FacingContact* facing : {&whole, &beside})
    for (const ContactFacet<3>& face : facing->contact) {
      Matrix3d force = Matrix3d::Zero();
      for (const FacingPart<3>& part : face.facing)
        for (int k = 0; k < 3; ++k)
          for (int i = 0; i < 3; ++i)
            force += part.moments.block<3, 3>(3 * k, 3 * i);
      const Matrix3d area = -face.measure * face.frame[0];
      RC_ASSERT((force - area).norm() < 1e-12);
    }
}

RC_GTEST_PROP(FacingFaces, have_the_contact_part_of_their_polygons,
              (Random random)) {
  const FacingContact facing({0, 0, -1}, 0.5, random);
  const SolidProblem& problem = facing.stack.problem;
  const SurfaceTractions on_faces = facing.on_faces();
  const VectorXd part = facing_contact_error(
      problem.mesh, problem.faces, problem.surface, problem.law,
      {facing.nodal, on_faces}, facing.displacement);
  for (std::size_t m = 0; m < facing.contact.size(); ++m) {
    const double of_face =
        2 * contact_term<3>(facing.contact[m], facing.tractions[m]);
    RC_ASSERT(std::abs(of_face - part[facing.contact[m].index]) <
              1e-9 * part.cwiseAbs().maxCoeff());
  }
}

TEST(FacingFaces, none_where_friction_has_no_bound) {
  Random random(1);
  FacingContact facing({0, 0, -1}, 0.5, random);
  SolidProblem& problem = facing.stack.problem;
  const auto count = [&] {
    return facing_faces(problem.mesh, problem.faces, problem.surface,
                        problem.law, facing.displacement)
        .size();
  };
  EXPECT_GT(count(), 0u);
  problem.law.friction[0] = 1e30;
  EXPECT_EQ(count(), 0u);
}

}  // namespace
}  // namespace ffcontact
