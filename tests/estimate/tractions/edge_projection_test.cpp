// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/edge_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/elastic/rigid_motions.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Three edges somewhere in the plane with friction of their nodes, in every third case
/// Tresca's bound.
Problem three_edges(Random& random) {
  Problem problem = body(rotated(irregular(3, 1, 3, 1, random), *real(-3, 3)),
                         material(1, 0));
  problem.law.friction = random_vector(4, random).cwiseAbs();
  if (random() % 3 == 0) set_friction(problem, 0.4);
  if (random() % 3 == 0) problem.law.slip_bound = problem.law.friction;
  return problem;
}

MatrixXd rigid_motions_of(const Problem& problem) {
  return free_rigid_motions(problem.mesh, Flags(problem.b.size(), 0));
}

RC_GTEST_PROP(EdgeProjection, is_nearer_than_any_other_traction_in_the_cone,
              (Random random)) {
  const Problem problem = three_edges(random);
  const EdgeProjection project(problem.line, problem.law,
                               rigid_motions_of(problem), 1);
  const Matrix4d mass = mass_of(problem.line, 1);
  const Vector4d r = random_vector(4, random), nearest = project(r);
  RC_ASSERT((project(nearest) - nearest).norm() < 1e-11);
  for (int k = 0; k < 50; ++k) {
    const Vector4d other =
        clamped_to_cone(problem.line, problem.law, 1, random_vector(4, random));
    // chords are up to 1.5 % inside the cone
    RC_ASSERT((r - nearest).dot(mass * (0.98 * other - nearest)) <= 1e-11);
  }
}

/// int r . z by Simpson's rule, which is exact.
RC_GTEST_PROP(EdgeProjection, resultants_are_the_work_along_motions,
              (Random random)) {
  Problem problem = three_edges(random);
  ContactLine& line = problem.line;
  if (random() % 2 == 0) line = turned_at_random(line, 0.7, random);
  const MatrixXd motions = rigid_motions_of(problem);
  const EdgeProjection project(line, problem.law, motions, 1);
  const Vector4d r = random_vector(4, random);
  const int i = line.edge_node(0, 1), j = line.edge_node(1, 1);
  ContactDensities density{Matrix2Xd::Zero(2, 3), Matrix2Xd::Zero(2, 3)};
  set_end_values(density, 1, r);
  const auto at = [&](double s) { return traction_at(line, density, 1, s); };
  const double l = line.length[1];
  const VectorXd work = project.resultants(r);
  for (Index k = 0; k < motions.cols(); ++k) {
    const Vector2d z_i = motions.col(k).segment<2>(2 * line.vertex[i]),
                   z_j = motions.col(k).segment<2>(2 * line.vertex[j]);
    const double simpson =
        l / 6 * (at(0).dot(z_i) + 2 * at(0.5).dot(z_i + z_j) + at(1).dot(z_j));
    RC_ASSERT(std::abs(work[k] - simpson) < 1e-13);
    RC_ASSERT(std::abs(work[k]) <= project.terms_of_resultants(r)[k] + 1e-14);
  }
}

RC_GTEST_PROP(EdgeProjection, has_the_slope_of_differences, (Random random)) {
  const Problem problem = three_edges(random);
  const MatrixXd motions = rigid_motions_of(problem);
  const EdgeProjection project(problem.line, problem.law, motions, 1);
  const Vector4d r = random_vector(4, random);
  const VectorXd eta = random_vector(motions.cols(), random);
  constexpr double h = 1e-5;
  const auto at = [&](double t) -> VectorXd {
    return project.resultants(project(project.moved(r, t * eta)));
  };
  const VectorXd before = (at(0) - at(-h)) / h, after = (at(h) - at(0)) / h;
  RC_PRE((before - after).norm() < 1e-3);
  RC_ASSERT((project.slope(project(r), r) * eta - (before + after) / 2).norm() <
            1e-4);
}

TEST(EdgeProjection, of_edges_that_slip_is_on_the_side_of_the_cone) {
  Problem problem = body(rectangle(2, 1, 2, 1), material(1, 0));
  problem.law.friction = Vector3d(0.2, 0.5, 1);
  const MatrixXd motions = rigid_motions_of(problem);
  const Vector4d pressed(-2, 0.1, -1, 0.3);
  const auto projected = [&](Carrying carrying) {
    return EdgeProjection(problem.line, problem.law, motions, 0,
                          carrying)(pressed);
  };
  const Vector4d forward = projected(Carrying::slip_forward),
                 backward = projected(Carrying::slip_backward);
  const double first = problem.law.friction[problem.line.edge_node(0, 0)],
               second = problem.law.friction[problem.line.edge_node(1, 0)];
  EXPECT_LT(forward[0], -0.5);
  EXPECT_NEAR(forward[1], first * forward[0], 1e-14);
  EXPECT_NEAR(forward[3], second * forward[2], 1e-14);
  EXPECT_NEAR(backward[1], -first * backward[0], 1e-14);
  EXPECT_NEAR(backward[3], -second * backward[2], 1e-14);
  EXPECT_EQ(projected(Carrying::nothing), Vector4d::Zero());
  problem.law.slip_bound = Vector3d::Constant(0.2);
  const Vector4d bounded = projected(Carrying::nothing);
  EXPECT_EQ(bounded[0], 0);
  EXPECT_EQ(bounded[2], 0);
  EXPECT_NEAR(bounded[3], 0.2, 1e-12);
}

}  // namespace
}  // namespace ffcontact
