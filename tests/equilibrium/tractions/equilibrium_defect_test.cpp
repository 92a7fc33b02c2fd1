// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"

#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "support/estimates.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A body with friction, supports, tractions and body forces, and its admissible fields.
struct Built {
  Problem problem = example_1(Multiplier::force, 4);
  Equilibrated fields;
  std::vector<CompositeStress> stress;
  Built() {
    add_body_force(problem, {0.02, -0.03});
    fields = equilibrated(problem, solved(problem));
    stress = admissible_stress(problem, fields);
  }
  EquilibriumDefect defect() const {
    return defect_of(problem, fields, stress);
  }
  double scale() const { return fields.stress.cwiseAbs().maxCoeff(); }
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
    std::vector<CompositeStress> stress = admissible_stress(problem, fields);
    stress[0] *= 1.001;
    return defect_of(problem, fields, stress).largest();
  };
  const double one = defect(c);
  RC_ASSERT(std::abs(defect(scaled(c, 1e3)) - one) < 1e-6 * one);
}

TEST(EquilibriumDefect, refuses_sizes_that_do_not_fit) {
  Built built;
  built.stress.pop_back();
  EXPECT_EQ(refusal([&] { built.defect(); }),
            "stress has 63 values where 64 are needed");
}

}  // namespace
}  // namespace ffcontact
