// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "support/cases.hpp"
#include "support/cells.hpp"
#include "support/estimates.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A body with friction, supports, tractions and body forces, and its admissible fields.
struct Built {
  Problem problem = example_1(Multiplier::force, 4);
  Equilibrated fields;
  std::vector<SubcellStress<2>> stress;
  Built() {
    add_body_force(problem, {0.02, -0.03});
    fields = equilibrated(problem, solved(problem));
    stress = admissible_stress(problem, fields);
  }
  EquilibriumDefect defect() const {
    return defect_of(problem, fields, stress);
  }
  double scale() const { return fields.stress.mean.cwiseAbs().maxCoeff(); }
};

RC_GTEST_PROP(EquilibriumDefect, of_the_first_guess_is_rounding, ()) {
  const Problem problem = problem_of(*random_case(0.5));
  const Equilibrated fields = equilibrated(problem, solved(problem));
  RC_ASSERT(
      defect_of(problem, fields, admissible_stress(problem, fields)).largest() <
      1e-10);
}

TEST(EquilibriumDefect, sees_every_spoiled_stress) {
  Built built;
  ASSERT_LT(built.defect().largest(), 1e-12);
  for (int t : {0, 17, 40, 63})
    for (int c = 0; c < 9; ++c)
      for (int s = 0; s < 3; ++s) {
        Built spoiled = built;
        spoiled.stress[t](s, c) += 1e-4 * built.scale();
        EXPECT_GT(spoiled.defect().largest(), 1e-6)
            << "triangle " << t << ", value " << s << ", " << c;
      }
}

TEST(EquilibriumDefect, tells_divergence_from_jumps_and_boundary) {
  Built body, boundary, jump;
  body.fields.loads(3, 12) += 1;
  EXPECT_GT(body.defect().divergence, 1e-3);
  EXPECT_LT(body.defect().jump, 1e-12);
  EXPECT_LT(body.defect().boundary, 1e-12);

  for (int e = 0; e < boundary.problem.edges.count(); ++e)
    if (boundary.problem.edges.on_boundary(e))
      boundary.fields.boundary.moments.col(e).array() += 1;
  EXPECT_LT(boundary.defect().divergence, 1e-12);
  EXPECT_LT(boundary.defect().jump, 1e-12);
  EXPECT_GT(boundary.defect().boundary, 1e-3);

  // a constant has no divergence
  for (int c = 0; c < 9; ++c) jump.stress[20].col(c) += Vector3d(1, 0, 0);
  EXPECT_LT(jump.defect().divergence, 1e-12);
  EXPECT_GT(jump.defect().jump, 1e-3);
}

TEST(EquilibriumDefect, reads_no_boundary_data_where_a_support_answers) {
  Built built;
  for (int e = 0; e < built.problem.edges.count(); ++e)
    for (int c = 0; c < 4; ++c)
      if (!built.fields.boundary.known(c % 2, e))
        built.fields.boundary.moments(c, e) = 1e9;
  EXPECT_LT(built.defect().largest(), 1e-12);
}

RC_GTEST_PROP(EquilibriumDefect, is_relative_to_the_largest_traction, ()) {
  const Case c = *random_case(0.3);
  const auto defect = [](const Case& c) {
    const Problem problem = problem_of(c);
    const Equilibrated fields = equilibrated(problem, solved(problem));
    std::vector<SubcellStress<2>> stress = admissible_stress(problem, fields);
    stress[0] *= 1.001;
    return defect_of(problem, fields, stress).largest();
  };
  const double one = defect(c);
  RC_ASSERT(std::abs(defect(scaled(c, 1e3)) - one) < 1e-6 * one);
}

template <int d>
double defect_of_spoilt_loads(bool on_facets, Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  Loads<d> loads = balanced_loads<d>(x, random);
  const SubcellStress<d> stress =
      composite_stress<d>(x, loads.on_facets, loads.in_body);
  double& spoilt =
      on_facets ? loads.on_facets.reshaped()[random() % loads.on_facets.size()]
                : loads.in_body.reshaped()[random() % loads.in_body.size()];
  spoilt += 1e-3;
  const EquilibriumDefect defect =
      cell_defect<d>(x, stress, loads.on_facets, loads.in_body);
  return on_facets ? defect.jump : defect.divergence;
}

RC_GTEST_PROP(EquilibriumDefect, sees_other_loads, (Random random)) {
  for (bool on_facets : {false, true}) {
    RC_ASSERT(defect_of_spoilt_loads<2>(on_facets, random) > 1e-4);
    RC_ASSERT(defect_of_spoilt_loads<3>(on_facets, random) > 1e-4);
  }
}

TEST(EquilibriumDefect, boundary_counts_known_components_alone) {
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
