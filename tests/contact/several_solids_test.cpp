// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "support/free_displacement.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solid_defects.hpp"
#include "support/solid_stacks.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Of a stack between walls under a uniform pressure.
struct UniformPressure {
  SolidStack stack;
  ContactSolution<3> solution;

  explicit UniformPressure(SolidStack any) : stack(std::move(any)) {
    put_between_walls(stack);
    stack.problem.load(stack.label(0, high_z), {0, 0, -10});
    solution = stack.problem.solve();
  }

  double displacement_defect() const {
    const double E = 13e3, nu = 0.2;
    const VectorXd exact =
        nodal_values(stack.problem.mesh, [&](const Vector3d& x) {
          const double low = -static_cast<double>(stack.last());
          return Vector3d(nu * 10 / E * x.x(), nu * 10 / E * x.y(),
                          -10 / E * (x.z() - low));
        });
    return (solution.displacement - exact).norm() / exact.norm();
  }

  /// Of p = 10 and no friction; a wall takes any force along it.
  double traction_defect() const {
    const ContactSurface& surface = stack.problem.surface;
    double largest = 0;
    for (int i = 0; i < surface.node_count(); ++i) {
      const Vector3d t = solution.force.col(i) / surface.area[i];
      const Vector3d x = stack.problem.mesh.vertices.col(surface.vertex[i]);
      const bool at_wall = x.x() == 0 || x.y() == 0;
      largest = std::max(
          {largest, std::abs(t[0] + 10), at_wall ? 0 : t.tail<2>().norm()});
    }
    return largest;
  }
};

RC_GTEST_PROP(SeveralSolids, a_uniform_pressure_passes_exactly,
              (Random random)) {
  const UniformPressure pressed(
      random_stack(*rc::gen::inRange(2, 4), *real(0, 1), random));
  RC_ASSERT(pressed.solution.accepted({}));
  RC_ASSERT(pressed.displacement_defect() < 1e-10);
  RC_ASSERT(pressed.traction_defect() < 1e-9);
}

TEST(SeveralSolids, a_uniform_pressure_passes_from_7_cells_to_11) {
  const auto brick_of = [](int cells, double low) {
    SolidMesh mesh = brick({cells, cells, 1}, {3, 2, 1});
    mesh.vertices.row(2).array() += low;
    return mesh;
  };
  for (const int upper : {7, 11}) {
    const UniformPressure pressed(
        SolidStack({brick_of(upper, 0), brick_of(18 - upper, -1)}, 0.3));
    EXPECT_TRUE(pressed.solution.accepted({}));
    EXPECT_LT(pressed.displacement_defect(), 1e-10);
    EXPECT_LT(pressed.traction_defect(), 1e-9);
  }
}

/// u of bodies that stick, and of one body, at the same places.
RC_GTEST_PROP(SeveralSolids, that_stick_are_one_body, (Random random)) {
  const SolidMesh upper = moved(brick({3, 2, 2}, {3, 2, 2}), 1, 0.15, random);
  SolidMesh lower = upper;  // a mirror image, whose upper side matches
  lower.vertices.row(2) *= -1;
  lower.cells.row(0).swap(lower.cells.row(1));
  for (int& label : lower.boundary_label)
    label = label == low_z ? high_z : label == high_z ? low_z : label;
  const auto load = [](SolidProblem& problem, int top, int ground, int side) {
    problem.load(top, {0.3, 0.1, -10});
    problem.load(side, {-0.1, 0.2, -0.1});
    problem.move(ground, [](const Vector3d&) { return Vector3d::Zero(); });
  };
  SolidStack stack({upper, lower}, 100);
  SolidProblem& parts = stack.problem;
  load(parts, stack.label(0, high_z), stack.label(1, low_z),
       stack.label(0, high_x));
  const ContactSolution<3> solution = parts.solve();
  RC_ASSERT(solution.accepted({}));
  for (ContactState state : solution.state)
    RC_PRE(state == ContactState::stick);

  SolidMesh whole = parts.mesh;  // the second body's vertices for the first's
  std::vector<int> own(whole.vertex_count(), -1);
  for (int i = 0; i < parts.surface.node_count(); ++i)
    visit_opposite(parts.surface, i, [&](int vertex, double) {
      own[parts.surface.vertex[i]] = vertex;
    });
  RowMatrix A = parts.A;
  VectorXd b = parts.b;
  Triplets glue;
  for (Index v = 0; v < whole.vertices.cols(); ++v)
    for (int c = 0; c < 3; ++c)
      glue.emplace_back(3 * v + c, 3 * (own[v] < 0 ? v : own[v]) + c, 1);
  const auto T = packed<RowMatrix>(A.rows(), A.rows(), glue);
  RowMatrix glued = T.transpose() * A * T;
  for (Index dof = 0; dof < b.size(); ++dof)
    if (own[dof / 3] >= 0) glued.coeffRef(dof, dof) = 1e30;
  const VectorXd u =
      T * displacement(elastic_system(glued, T.transpose() * b, 3));
  RC_ASSERT((solution.displacement - u).norm() < 1e-9 * u.norm());
}

RC_GTEST_PROP(SeveralSolids, fulfil_the_law_and_equilibrium, (Random random)) {
  const SolidStack stack = random_solids(*real(0, 3), random);
  const ContactSolution<3> solution = stack.problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(stack.problem, solution).largest() < 1e-8);
}

/// Own corners on walls that the other body does not share, where as many multipliers as
/// nodes would hold it between its vertices, and no iteration ended.
TEST(SeveralSolids, of_which_one_alone_is_at_a_wall) {
  for (unsigned seed : {2151u, 2257u, 2399u, 2968u}) {
    Random random(seed);
    const double mu = Uniform{0, 3}(random);
    EXPECT_TRUE(random_solids(mu, random).problem.solve().accepted({})) << seed;
  }
}

RC_GTEST_PROP(SeveralSolids, newton_and_the_fixed_point_agree,
              (Random random)) {
  const SolidStack stack = random_solids(*real(0, 0.5), random);
  ContactSettings settings;
  settings.solver = ContactSolver::fixed_point;
  const ContactSolution<3> newton = stack.problem.solve(),
                           steps = stack.problem.solve(settings);
  RC_ASSERT(steps.accepted(settings) && !steps.history.empty());
  RC_ASSERT((newton.displacement - steps.displacement).norm() <
            1e-7 * newton.displacement.norm());
}

/// Bodies, loads and supports in other units of force.
RC_GTEST_PROP(SeveralSolids, do_not_depend_on_units, (Random random)) {
  SolidStack stack = random_solids(*real(0, 1), random);
  const ContactSolution<3> solution = stack.problem.solve();
  const double unit = std::pow(10, *rc::gen::inRange(-9, 10));
  stack.problem.A *= unit;
  stack.problem.b *= unit;
  const ContactSolution<3> in_units = stack.problem.solve();
  RC_ASSERT((in_units.force - unit * solution.force).norm() <
            1e-8 * unit * solution.force.norm());
}

/// A small body on a large one, in part beyond it: what it feels is what the other does.
RC_GTEST_PROP(SeveralSolids, that_face_each_other_in_part, (Random random)) {
  SolidMesh upper =
      random_brick(random_cells(2, 4, random), {*real(-2, 2), *real(-1, 1), 0},
                   {3, 2, 1}, random);
  SolidStack stack({upper, random_brick(random_cells(2, 4, random), {0, 0, -1},
                                        {3, 2, 1}, random)},
                   *real(0, 1));
  SolidProblem& problem = stack.problem;
  problem.move(stack.label(0, high_z),
               [](const Vector3d&) { return Vector3d(1e-3, 0, -2e-3); });
  problem.move(stack.label(1, low_z),
               [](const Vector3d&) { return Vector3d::Zero(); });
  const ContactSolution<3> solution = problem.solve();
  RC_ASSERT(solution.accepted({}));
  RC_ASSERT(defects(problem, solution).largest() < 1e-8);
  RC_ASSERT(solution.force.row(0).sum() < 0);
}

/// What holds nothing, even glued, is refused in any unit of force.
TEST(SeveralSolids, on_nothing_are_refused) {
  SolidMesh lower = brick({1, 1, 1}, {1, 1, 1});
  lower.vertices.row(2).array() -= 1;
  for (double unit : {1e-15, 1.0, 1e15}) {
    SolidStack stack({brick({1, 1, 1}, {1, 1, 1}), lower}, 0.3);
    stack.problem.A *= unit;
    stack.problem.load(stack.label(0, high_z), {0, 0, -unit});
    EXPECT_NE(refusal([&] {
                stack.problem.solve();
              }).find("no equilibrium: the loads push the body"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace ffcontact
