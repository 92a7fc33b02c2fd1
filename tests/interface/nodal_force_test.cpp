// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/interface/nodal_force.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/law/contact_law.hpp"
#include "support/bodies.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Work of the load on any displacement: sum of the forces' on its jumps.
double off_in_work(const Problem& problem, Random& random) {
  const ContactLine& line = problem.line;
  const Matrix2Xd force = random_matrix(2, line.node_count(), random);
  const VectorXd u = random_vector(problem.b.size(), random);
  ContactLaw<2> without_gap;
  const Matrix2Xd jump = displacement_against_foundation(line, without_gap, u);
  return std::abs(nodal_load(line, force, u.size()).dot(u) -
                  force.cwiseProduct(jump).sum());
}

RC_GTEST_PROP(NodalForce, works_on_jumps, (Random random)) {
  const double angle = *real(-3, 3);
  const Problem one =
      body(rotated(irregular(4, 2, 4, 2, random), angle), material(1, 0));
  RC_ASSERT(off_in_work(one, random) < 1e-13);
  const Bodies two =
      bodies({rotated(rectangle(5, 2, 5, 2), angle),
              rotated(shifted(rectangle(3, 2, 5, 2), {0, -2}), angle)},
             {material(1, 0), material(1, 0)}, {{0, bottom, 1, top}});
  RC_ASSERT(off_in_work(two.problem, random) < 1e-13);
}

/// Opposite bodies have opposite forces.
TEST(NodalForce, has_no_resultant_between_bodies) {
  const Bodies two =
      bodies({rectangle(5, 2, 5, 2), shifted(rectangle(3, 2, 5, 2), {0, -2})},
             {material(1, 0), material(1, 0)}, {{0, bottom, 1, top}});
  VectorXd load = VectorXd::Zero(two.problem.b.size());
  add_nodal_force(two.problem.line, 2, {3, -4}, load);
  EXPECT_NEAR(load.reshaped(2, load.size() / 2).rowwise().sum().norm(), 0,
              1e-14);
  EXPECT_EQ(load.segment<2>(2 * two.problem.line.vertex[2]), Vector2d(3, -4));
}

}  // namespace
}  // namespace ffcontact
