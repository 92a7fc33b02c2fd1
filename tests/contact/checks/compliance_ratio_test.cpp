// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/compliance_ratio.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Of a block 4 x 2 with cells x cells / 2 squares and modulus E on one with 8 x 4
/// squares and modulus 1.
Bodies pair_of(int cells, double E) {
  return bodies({shifted(rectangle(cells, cells / 2, 4, 2), {0, 2}),
                 rectangle(8, 4, 4, 2)},
                {material(E, 0.3), material(1, 0.3)}, {{0, bottom, 1, top}});
}

double ratio_of(const Problem& problem) {
  return compliance_ratio(problem.mesh, problem.edges, problem.line,
                          problem.system());
}

TEST(ComplianceRatio, is_that_of_the_moduli_on_equal_meshes) {
  EXPECT_NEAR(
      ratio_of(pair_of(8, 10).problem) / ratio_of(pair_of(8, 1).problem), 10,
      1e-9);
  EXPECT_NEAR(
      ratio_of(pair_of(8, 1).problem), 1,
      0.2);  // the corners of top and bottom belong to other numbers of triangles
}

TEST(ComplianceRatio, is_that_of_the_sizes_of_equal_bodies) {
  EXPECT_NEAR(
      ratio_of(pair_of(32, 1).problem) / ratio_of(pair_of(8, 1).problem), 4,
      0.4);
}

TEST(ComplianceRatio, of_traces_that_cannot_yield) {
  Bodies two = pair_of(8, 1);
  prescribe(two.problem, two.label(1, top), 1);
  EXPECT_NEAR(ratio_of(two.problem), 1e-12, 1e-20);
  prescribe(two.problem, two.label(0, bottom), 1);
  EXPECT_EQ(ratio_of(two.problem), 1);
  Bodies other = pair_of(8, 1);
  prescribe(other.problem, other.label(0, bottom), 1);
  EXPECT_NEAR(ratio_of(other.problem), 1e12, 1e4);
  Bodies sideways = pair_of(8, 1);
  const double before = ratio_of(sideways.problem);
  prescribe(sideways.problem, sideways.label(0, bottom), 0);
  EXPECT_EQ(ratio_of(sideways.problem), before);
}

/// Two squares on each other, turned by half a radian.
Bodies inclined_pair() {
  return bodies({rotated(shifted(rectangle(1, 1, 2, 2), {0, 2}), 0.5),
                 rotated(rectangle(1, 1, 2, 2), 0.5)},
                {material(3, 0.3), material(1, 0.1)}, {{0, bottom, 1, top}});
}

TEST(ComplianceRatio, of_rollers_counts_the_components_that_are_free) {
  Bodies two = inclined_pair();
  Problem& problem = two.problem;
  prescribe(problem, two.label(0, bottom), 0);
  prescribe(problem, two.label(1, top), 0);
  const ElasticSystem system = problem.system();
  const auto compliance = [&](int edge) {
    double sum = 0;
    for (const int v : problem.edges.vertices.col(edge))
      sum += 1 / system.stiffness.coeff(2 * v + 1, 2 * v + 1);
    return sum;
  };
  const FacingPiece& piece = problem.line.pieces[0];
  EXPECT_NEAR(ratio_of(problem),
              compliance(piece.opposite_edge) /
                  compliance(problem.line.edge[piece.contact_edge]),
              1e-12);
}

}  // namespace
}  // namespace ffcontact
