// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "support/bodies.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

BoundaryTractions tractions_of(const Problem& problem,
                               const ContactDensities& densities) {
  return boundary_tractions(problem.mesh, problem.edges,
                            prescribed_dofs(problem.A), problem.neumann,
                            problem.line, densities);
}

ContactDensities no_contact(const ContactLine& line) {
  return {Matrix2Xd::Zero(2, line.edge_count()),
          Matrix2Xd::Zero(2, line.edge_count())};
}

/// Whether a component is known on all edges of a label; edges that differ make it fail.
bool known(const Problem& problem, const BoundaryTractions& boundary, int label,
           int component) {
  int yes = 0, no = 0;
  for (int e = 0; e < problem.edges.count(); ++e)
    if (problem.edges.on_boundary(e) &&
        problem.mesh.boundary_label[problem.edges.boundary_index[e]] == label)
      ++(boundary.known(component, e) ? yes : no);
  EXPECT_TRUE(yes == 0 || no == 0);
  return yes > 0;
}

RC_GTEST_PROP(BoundaryTractions, are_known_where_no_dof_is_prescribed,
              (Random random)) {
  Problem problem = body(irregular(4, 3, 4, 3, random), material(1, 0.3));
  clamp(problem, top);
  prescribe(problem, right, 0);
  const BoundaryTractions boundary =
      tractions_of(problem, no_contact(problem.line));
  RC_ASSERT(
      (known(problem, boundary, left, 0) && known(problem, boundary, left, 1)));
  RC_ASSERT((known(problem, boundary, bottom, 0) &&
             known(problem, boundary, bottom, 1)));
  RC_ASSERT((!known(problem, boundary, right, 0) &&
             known(problem, boundary, right, 1)));
  RC_ASSERT(
      (!known(problem, boundary, top, 0) && !known(problem, boundary, top, 1)));
  for (int e = 0; e < problem.edges.count(); ++e)
    if (!problem.edges.on_boundary(e)) RC_ASSERT(!boundary.known.col(e).any());
}

RC_GTEST_PROP(BoundaryTractions,
              have_the_given_moments_in_either_direction_of_the_labelled_edges,
              (Random random)) {
  Problem problem = body(irregular(4, 3, 4, 3, random), material(1, 0.3));
  for (Index b = 0; b < problem.mesh.boundary.cols();
       ++b)  // the linear density (x, y)
    for (int end = 0; end < 2; ++end) {
      const Vector2d a =
          problem.mesh.vertices.col(problem.mesh.boundary(end, b));
      const Vector2d c =
          problem.mesh.vertices.col(problem.mesh.boundary(1 - end, b));
      problem.neumann.block<2, 1>(2 * end, b) =
          (a - c).norm() / 6 * (2 * a + c);
    }
  const BoundaryTractions boundary =
      tractions_of(problem, no_contact(problem.line));
  for (int e = 0; e < problem.edges.count(); ++e) {
    if (!problem.edges.on_boundary(e)) continue;
    if (problem.mesh.boundary_label[problem.edges.boundary_index[e]] == bottom)
      continue;
    const double length = edge_vector(problem.mesh, problem.edges, e).norm();
    Vector4d expected;
    expected << problem.mesh.vertices.col(problem.edges.vertices(0, e)),
        problem.mesh.vertices.col(problem.edges.vertices(1, e));
    RC_ASSERT((density_of(boundary.moments.col(e), length) - expected).norm() <
              1e-11);
  }
}

RC_GTEST_PROP(BoundaryTractions, are_the_contact_densities_on_the_line,
              (Random random)) {
  const Problem problem = body(rotated(irregular(4, 3, 4, 3, random), 0.5),
                               material(1, 0.3), {left, bottom});
  const ContactDensities densities{
      random_matrix(2, problem.line.edge_count(), random),
      random_matrix(2, problem.line.edge_count(), random)};
  const BoundaryTractions boundary = tractions_of(problem, densities);
  for (int k = 0; k < problem.line.edge_count(); ++k) {
    const Vector4d ends = density_of(boundary.moments.col(problem.line.edge[k]),
                                     problem.line.length[k]);
    for (int end = 0; end < 2; ++end) {
      const Vector2d r = ends.segment<2>(2 * end);
      RC_ASSERT(std::abs(r.dot(problem.line.edge_normal(k)) -
                         densities.normal(end, k)) < 1e-11);
      RC_ASSERT(std::abs(r.dot(problem.line.edge_tangent(k)) -
                         densities.tangential(end, k)) < 1e-11);
    }
  }
}

/// int r phi by Simpson's rule, which is exact.
RC_GTEST_PROP(BoundaryTractions, turn_with_the_directions, (Random random)) {
  Problem problem = body(rotated(irregular(4, 3, 4, 3, random), 0.5),
                         material(1, 0.3), {left, bottom});
  ContactLine& line = problem.line;
  line = turned_at_random(line, 1, random);
  const ContactDensities r{random_matrix(2, line.edge_count(), random),
                           random_matrix(2, line.edge_count(), random)};
  for (int e = 0; e < line.edge_count(); ++e) {
    const Vector2d first = traction_at(line, r, e, 0),
                   middle = traction_at(line, r, e, 0.5),
                   second = traction_at(line, r, e, 1);
    Vector4d expected;
    expected << first + 2 * middle, second + 2 * middle;
    RC_ASSERT(
        (contact_moments(line, r, e) - line.length[e] / 6 * expected).norm() <
        1e-14);
  }
}

/// A pressure that acts on the contact line itself, as a fluid's, is carried beside the
/// contact tractions, on both bodies.
TEST(BoundaryTractions, add_given_tractions_on_the_contact_line) {
  const Bodies two =
      bodies({shifted(rectangle(3, 2, 3, 2), {0, 2}), rectangle(3, 2, 3, 2)},
             {material(1, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
  Problem problem = two.problem;
  const ContactLine& line = problem.line;
  const ContactDensities contact{
      Matrix2Xd::Constant(2, line.edge_count(), -3),
      Matrix2Xd::Constant(2, line.edge_count(), 0.5)};
  const BoundaryTractions without = tractions_of(problem, contact);
  problem.neumann = Matrix4Xd::Random(4, problem.mesh.boundary.cols());
  const BoundaryTractions with = tractions_of(problem, contact);
  for (int k = 0; k < line.edge_count(); ++k)
    for (const int edge : {line.edge[k], line.opposite_edge[k]}) {
      const int b = problem.edges.boundary_index[edge];
      const bool same =
          problem.mesh.boundary(0, b) == problem.edges.vertices(0, edge);
      Vector4d given = problem.neumann.col(b);
      if (!same)
        given << problem.neumann.col(b).tail<2>(),
            problem.neumann.col(b).head<2>();
      EXPECT_LT(
          (with.moments.col(edge) - without.moments.col(edge) - given).norm(),
          1e-14);
    }
}

RC_GTEST_PROP(BoundaryTractions, are_opposite_on_facing_edges,
              (Random random)) {
  const Bodies two =
      bodies({shifted(rectangle(3, 2, 3, 2), {0, 2}), rectangle(3, 2, 3, 2)},
             {material(1, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
  const ContactLine& line = two.problem.line;
  const BoundaryTractions boundary =
      tractions_of(two.problem, {random_matrix(2, line.edge_count(), random),
                                 random_matrix(2, line.edge_count(), random)});
  for (int k = 0; k < line.edge_count(); ++k) {
    const Vector4d own = boundary.moments.col(line.edge[k]),
                   facing = boundary.moments.col(line.opposite_edge[k]);
    RC_ASSERT(boundary.known.col(line.opposite_edge[k]).all());
    RC_ASSERT((own.head<2>() + facing.tail<2>()).norm() +
                  (own.tail<2>() + facing.head<2>()).norm() ==
              0);
  }
}

TEST(BoundaryTractions, a_neumann_edge_between_two_supports_stays_neumann) {
  Problem problem = body(rectangle(3, 1, 3, 1), material(1, 0.3));
  // both ends of the first edge of the top, but not of the whole label
  for (int i : {4, 5}) {
    prescribe_dof(problem, 2 * i, 0);
    prescribe_dof(problem, 2 * i + 1, 0);
  }
  EXPECT_TRUE(
      known(problem, tractions_of(problem, no_contact(problem.line)), top, 0));
}

TEST(BoundaryTractions, refuses_tractions_that_do_not_fit) {
  Problem problem = body(rectangle(3, 1, 3, 1), material(1, 0.3));
  problem.neumann(2, 1) = std::nan("");
  EXPECT_EQ(refusal([&] { tractions_of(problem, no_contact(problem.line)); }),
            "traction[6] is nan, not a finite number");
  problem.neumann = Matrix4Xd::Zero(4, 7);
  EXPECT_EQ(refusal([&] { tractions_of(problem, no_contact(problem.line)); }),
            "tractions has 7 values where 8 are needed");
}

TEST(ContactEdgeNumbers, are_the_inverse_of_the_lines_edges) {
  const Problem problem =
      body(rectangle(3, 2, 3, 2), material(1, 0), {left, bottom});
  const std::vector<int> number =
      contact_edge_numbers(problem.line, problem.edges);
  for (int e = 0; e < problem.line.edge_count(); ++e)
    EXPECT_EQ(number[problem.line.edge[e]], e);
  EXPECT_EQ(
      std::count_if(number.begin(), number.end(), [](int n) { return n >= 0; }),
      5);
}

}  // namespace
}  // namespace ffcontact
