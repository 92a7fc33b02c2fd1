// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_densities.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(ContactDensities, are_continuous_between_nodes, (Random random)) {
  const Problem problem = body(irregular(5, 2, 5, 2, random), material(1, 0));
  const ContactLine& line = problem.line;
  const Matrix2Xd nodal = random_matrix(2, line.node_count(), random);
  const ContactDensities densities = edge_densities(line, nodal);
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector4d r = end_values(densities, e);
    RC_ASSERT(r.head<2>() == nodal.col(line.edge_node(0, e)));
    RC_ASSERT(r.tail<2>() == nodal.col(line.edge_node(1, e)));
  }
  RC_ASSERT(largest_traction(densities) == nodal.cwiseAbs().maxCoeff());
}

TEST(ContactDensities, are_set_edge_by_edge) {
  ContactDensities densities{Matrix2Xd::Zero(2, 3), Matrix2Xd::Zero(2, 3)};
  set_end_values(densities, 1, {1, -2, 3, -4});
  EXPECT_EQ(end_values(densities, 1), Vector4d(1, -2, 3, -4));
  EXPECT_EQ(densities.normal.col(1), Vector2d(1, 3));
  EXPECT_EQ(densities.tangential.col(1), Vector2d(-2, -4));
  EXPECT_EQ(end_values(densities, 0), Vector4d::Zero());
  EXPECT_EQ(end_values(densities, 2), Vector4d::Zero());
  EXPECT_EQ(largest_traction(densities), 4);
  EXPECT_EQ(largest_traction({Matrix2Xd(2, 0), Matrix2Xd(2, 0)}), 0);
}

}  // namespace
}  // namespace ffcontact
