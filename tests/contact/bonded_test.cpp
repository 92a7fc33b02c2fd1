// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/bonded.hpp"

#include <gtest/gtest.h>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/linear/sparse_lu.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

const Material stiff = material(70e3, 0.3), soft = material(3e3, 0.3);

/// Linear displacements pass through interfaces that do not match, straight or inclined, in
/// one step.
RC_GTEST_PROP(Bonded, linear_displacements_pass, (Random random)) {
  const Bodies two = random_patch(stiff, 1, random);
  const ContactSolution<2> solution = solved(two.problem);
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(solution.iterations == 1);
  RC_ASSERT(relative_difference(solution.displacement,
                                nodal_values(two.problem.mesh, linear_field)) <
            1e-11);
}

/// The displacement of one mesh 6 x 9 with both materials at a place.
class OneMesh {
 public:
  explicit OneMesh(int nx) : problem_(body(rectangle(nx, 9, 6, 9), soft)) {
    for (int t = 0; t < problem_.mesh.cell_count(); ++t)
      if (centroid_of(problem_.mesh, t).y() > 5)
        problem_.hooke[t] = stiff.hooke();
    problem_.A = stiffness(problem_.mesh, problem_.hooke);
    add_traction(problem_, top, {3, 7});
    clamp(problem_, bottom);
    u_ = SparseLu(SparseMatrix(problem_.A)).solve(problem_.b);
  }
  Vector2d at(const Vector2d& x) const {
    Index nearest;
    (problem_.mesh.vertices.colwise() - x).colwise().norm().minCoeff(&nearest);
    return u_.segment<2>(2 * nearest);
  }

 private:
  Problem problem_;
  VectorXd u_;
};

TEST(Bonded, meshes_that_match_are_one_mesh) {
  const OneMesh one(8);
  for (const Multiplier multiplier : both_multipliers)
    for (const ContactSolver solver :
         {ContactSolver::newton, ContactSolver::fixed_point}) {
      Bodies two = bonded_bodies(
          {shifted(rectangle(8, 4, 6, 4), {0, 5}), rectangle(8, 5, 6, 5)},
          {stiff, soft}, {{0, bottom, 1, top}});
      pull(two);
      two.problem.law.multiplier = multiplier;
      ContactSettings settings;
      settings.solver = solver;
      const ContactSolution<2> solution = solved(two.problem, settings);
      ASSERT_TRUE(solution.accepted(settings));
      EXPECT_EQ(solution.state, all_stick(two.problem.line.node_count()));
      EXPECT_LT(relative_difference(
                    solution.displacement,
                    nodal_values(two.problem.mesh,
                                 [&](const Vector2d& x) { return one.at(x); })),
                1e-11);
    }
}

TEST(Bonded, carries_tension_and_shear) {
  Bodies two = bonded_blocks(7, 11, stiff, soft);
  pull(two);
  const ContactSolution<2> solution = solved(two.problem);
  ASSERT_TRUE(solution.accepted({}));
  EXPECT_NEAR(solution.force.row(0).sum(), 42, 1e-10);
  EXPECT_NEAR(std::abs(solution.force.row(1).sum()), 18, 1e-10);
}

/// Deviation of the pressures of a stack of three from a uniform tension.
double tension_defect(int first, int second, int third) {
  Bodies three = bonded_bodies(
      {shifted(rectangle(first, 3, 6, 4), {0, 5}),
       shifted(rectangle(second, 4, 6, 3), {0, 2}), rectangle(third, 2, 6, 2)},
      {stiff, stiff, stiff}, {{0, bottom, 1, top}, {1, bottom, 2, top}});
  add_traction(three.problem, three.label(0, top), {0, 7});
  prescribe(three.problem, three.label(2, bottom), 1);
  for (int k = 0; k < 3; ++k) prescribe(three.problem, three.label(k, left), 0);
  const ContactSolution<2> solution = solved(three.problem);
  EXPECT_TRUE(solution.accepted({}));
  return relative_difference(
      solution.pressure, Vector2d(7, 0).replicate(1, solution.pressure.cols()));
}

TEST(Bonded, three_bodies_pass_uniform_tension) {
  EXPECT_LT(tension_defect(7, 11, 5), 1e-10);
  EXPECT_LT(tension_defect(6, 6, 6), 1e-10);  // with ends that are idle
}

TEST(Bonded, a_rigid_foundation_holds_like_a_support) {
  Problem bonded = bonded_body(rectangle(8, 6, 4, 3), stiff, {bottom, left});
  Problem held = bonded_body(rectangle(8, 6, 4, 3), stiff, {bottom, left});
  for (Problem* problem : {&bonded, &held}) add_traction(*problem, top, {1, 5});
  for (int side : {bottom, left}) clamp(held, side);
  const VectorXd u = SparseLu(SparseMatrix(held.A)).solve(held.b);
  const ContactSolution<2> solution = solved(bonded);
  ASSERT_TRUE(solution.accepted({}));
  EXPECT_LT(relative_difference(solution.displacement, u), 1e-11);
}

/// Where both traces end on a line of symmetry multipliers stay what tractions are.
TEST(Bonded, ends_that_are_held_do_not_spoil_the_pressures) {
  for (int upper : {7, 11, 22}) {
    Bodies two = bonded_blocks(upper, 7, stiff, soft);
    for (int k = 0; k < 2; ++k) prescribe(two.problem, two.label(k, left), 0);
    pull(two);
    const ContactSolution<2> solution = solved(two.problem);
    ASSERT_TRUE(solution.accepted({}));
    EXPECT_LT(lumped_pressures(two.problem.line, solution.force)
                  .cwiseAbs()
                  .maxCoeff(),
              25);
  }
}

TEST(Bonded, supports_that_tear_it_apart_are_refused) {
  Bodies two = bonded_blocks(5, 7, stiff, soft);
  prescribe_around(two);
  const int corner = two.joined.first_vertex[1] + 8 * 4;
  two.problem.b[2 * corner] += 1e-4 * penalty;
  EXPECT_TRUE(
      says(refusal([&] { solved(two.problem); }),
           "hold what is bonded 0.0001 apart at (0, 5): make them the same"));
  Problem rigid = bonded_body(rectangle(4, 4, 1, 1), stiff);
  clamp(rigid, left, [](const Vector2d&) { return Vector2d(0, 0.1); });
  EXPECT_TRUE(says(refusal([&] { solved(rigid); }),
                   "hold what is bonded 0.1 apart at (0, 0)"));
}

TEST(Bonded, the_law_asks_for_no_jump_and_nothing_else) {
  const Problem problem = bonded_body(rectangle(3, 3, 1, 1), stiff);
  const NodalLaw law = nodal_law(problem.law, problem.line);
  ASSERT_TRUE(law.is_bonded());
  const Index rows = 2 * law.node_count();
  VectorXd P = VectorXd::LinSpaced(rows, -3, 4), v = VectorXd::Zero(rows);
  EXPECT_EQ(law_violation(law, P, v, {1, 1}), 0);
  VectorXd put = P;
  put_into_law(law, all_stick(law.node_count()), put);
  EXPECT_EQ(put, P);
  for (Index row = 0; row < rows; ++row) {
    v[row] = -1e-3;
    EXPECT_NEAR(law_violation(law, P, v, {1, 1}), 1e-3, 1e-15);
    v[row] = 0;
  }
}

TEST(Bonded, the_cone_is_all_of_the_plane) {
  const Problem problem = bonded_body(rectangle(3, 3, 1, 1), stiff);
  const EdgeCone cone = edge_cone(problem.line, problem.law, 1);
  EXPECT_EQ(cone.d.size(), 0);
  EXPECT_FALSE(cone.frictionless.any());
  const Vector4d r(3, -4, 5, 6);
  EXPECT_EQ(clamped_to_cone(problem.line, problem.law, 1, r), r);
  ContactDensities densities{Matrix2Xd::Constant(2, 3, 2.0),
                             Matrix2Xd::Constant(2, 3, -5.0)};
  EXPECT_EQ(cone_defect(problem.line, problem.law, densities), 0);
}

}  // namespace
}  // namespace ffcontact
