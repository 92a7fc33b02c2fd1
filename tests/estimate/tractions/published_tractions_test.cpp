// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/published_tractions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/interface/curve_directions.hpp"
#include "support/problems.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The bottom of a rectangle with contact along n at an angle to the vertical.
Problem line_along(double angle) {
  Problem problem = body(rectangle(3, 1, 3, 1), material(1, 0.3));
  const ContactLine line =
      smooth_contact_line(problem.mesh, problem.edges, {bottom});
  problem.line = along_directions(problem.mesh, problem.edges, line,
                                  Vector2d(std::sin(angle), -std::cos(angle))
                                      .replicate(1, line.node_count()));
  set_friction(problem, 0.5);
  return problem;
}

/// Tractions that leave the cone at both ends of the second edge, by opposite amounts.
ContactDensities one_edge_outside() {
  ContactDensities r{Matrix2Xd::Constant(2, 3, -1), Matrix2Xd::Zero(2, 3)};
  r.tangential.col(1) << 0.7, -0.7;
  return r;
}

TEST(PublishedTractions, are_shifted_into_the_cone_along_their_edge) {
  const Problem problem = line_along(0);
  const ConeCorrection correction = published_tractions(
      problem.mesh, problem.line, problem.law, one_edge_outside());
  EXPECT_EQ(correction.uncorrected, std::vector<int>{});
  EXPECT_NEAR(correction.shift[1], 0.2, 1e-15);
}

/// The shift of an edge has no moment along the edge alone.
TEST(PublishedTractions, stay_as_they_are_where_the_tangent_leaves_the_edge) {
  const Problem problem = line_along(0.1);
  const ContactDensities given = one_edge_outside();
  const ConeCorrection correction =
      published_tractions(problem.mesh, problem.line, problem.law, given);
  EXPECT_EQ(correction.uncorrected, std::vector<int>{1});
  EXPECT_EQ(correction.shift, VectorXd::Zero(3));
  EXPECT_EQ(correction.densities.tangential, given.tangential);
}

}  // namespace
}  // namespace ffcontact
