// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_rows.hpp"

#include <gtest/gtest.h>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/solid_corners.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// On a layer that carries P.
TEST(SharedRows, have_the_y_of_their_v) {
  Random random(1);
  SolidProblem problem = SolidCorner(2, 0, random).problem;
  problem.law.layer = {1e-2, 2e-2};
  const ProblemUnknowns of{problem};
  const Index count = count_of(of.trace.held);
  SharedRows rows(of.unknowns.shared);
  rows.put(random_vector(count, random));
  const VectorXd P = random_vector(count, random),
                 v = random_vector(count, random);
  VectorXd y = VectorXd::Zero(of.system.dof_count()), found = v;
  rows.put_own(v, P, y);
  rows.put_motion(y, P, found);
  for (const SharedVertex& shared : of.unknowns.shared)
    for (int k = 0; k < shared.own; ++k)
      EXPECT_NEAR(found[shared.rows[k]], v[shared.rows[k]], 1e-12);
}

}  // namespace
}  // namespace ffcontact
