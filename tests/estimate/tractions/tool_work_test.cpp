// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/tool_work.hpp"

#include <gtest/gtest.h>

#include "ffcontact/estimate/tractions/nearest_in_cone.hpp"
#include "support/nested_reference.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A block clamped at its top, maybe guided at a side, which takes forces beside the tool
/// below it.
struct PushedBlock {
  Mesh mesh;
  int guided;  ///< its label, or 0
  double friction, slip_bound;
  Multiplier multiplier;
  RigidTool tool;

  Problem on(const Mesh& body_mesh) const {
    Problem problem = body(body_mesh, material(1000, 0.3));
    clamp(problem, top);
    if (guided != 0) prescribe(problem, guided, 0);
    set_friction(problem, friction);
    if (slip_bound > 0)
      problem.law.slip_bound = everywhere(problem.line, slip_bound);
    problem.law.multiplier = multiplier;
    return problem;
  }
};

struct Pushed {
  Problem problem;
  ToolSolution found;
  SolvedBody<2> body;

  Pushed(Problem stated, const RigidTool& tool)
      : problem(std::move(stated)),
        found(solve_contact_with_tool(problem.mesh, problem.line, problem.law,
                                      problem.system(), tool)) {
    problem.law = found.law;
    body = solved_body(problem, found.solution);
    body.tool = tool;
  }
  Estimate<2> estimate(const EstimateSettings<2>& settings = {}) const {
    return estimate_error(topology_of(problem.mesh), problem.line,
                          problem.system(), body, settings);
  }
  /// What tractions miss of the push, as a part of it.
  double missed(const ContactDensities& r) const {
    const ToolWork work = tool_work(problem.mesh, problem.line, body);
    return (resultants_of(problem.line, r, work.fields) - work.work).norm() /
           work.work.norm();
  }
};

/// Pressed by a force within the middle of the line, turned by a moment.
PushedBlock random_pushed(Random& random) {
  PushedBlock block{
      irregular(*rc::gen::inRange(3, 7), *rc::gen::inRange(2, 5), 6, 4, random),
      *rc::gen::element<int>(0, left, right),
      *rc::gen::element(0.0, 0.4),
      0,
      *rc::gen::element(Multiplier::force, Multiplier::pressure),
      {}};
  const double force = 10 * *real(0.5, 1), along = *real(-0.2, 0.2);
  block.tool = {
      {3, 0},
      Matrix3d::Identity(),
      {block.friction * along * force, force, *real(-0.5, 0.5) * force}};
  if (block.friction == 0) block.tool.free = Matrix3d::Identity().rightCols(2);
  return block;
}

RC_GTEST_PROP(ToolWork, tractions_pass_on_what_pushes_the_tool,
              (Random random)) {
  const PushedBlock block = random_pushed(random);
  const Pushed pushed(block.on(block.mesh), block.tool);
  RC_ASSERT(pushed.found.solution.accepted({}));
  for (const Tractions kind : {Tractions::fixed, Tractions::free}) {
    const Estimate<2> found = pushed.estimate(sweeps(3, kind));
    RC_ASSERT(found.reason == "");
    RC_ASSERT(pushed.missed(found.tractions) < 1e-11);
  }
}

TEST(ToolWork, what_is_missed_is_out_of_equilibrium) {
  const Problem problem =
      body(rectangle(6, 4, 6, 4), material(1000, 0.3), {bottom});
  SolvedBody<2> solved;
  solved.tool = RigidTool{{3, 0}, Matrix3d::Identity(), {0, 12, 6}};
  const ToolWork tool = tool_work(problem.mesh, problem.line, solved);
  ContactDensities r{Matrix2Xd::Constant(2, 6, -2), Matrix2Xd::Zero(2, 6)};
  // the moment of a uniform pressure is 0: 6 N are missed, by a field that is 3 at the
  // ends of a line 6 long
  EXPECT_NEAR(tool_defect(problem.line, tool, r), 6 / 3.0 / 6, 1e-14);
  r.normal.array() -= 1;
  EXPECT_NEAR(tool_defect(problem.line, tool, r), 1, 1e-14);
  EXPECT_EQ(
      tool_defect(problem.line, tool_work(problem.mesh, problem.line, {}), r),
      0);
}

/// |sigma - sigma_hat|^2 + |u - u_hat|^2 over its bound, of the reference with its own
/// motion.
double part_of_bound(const PushedBlock& block, int finer) {
  Problem on_finer_mesh = block.on(subdivided(block.mesh, finer));
  on_finer_mesh.law.multiplier = Multiplier::force;
  const Pushed coarse(block.on(block.mesh), block.tool),
      fine(std::move(on_finer_mesh), block.tool);
  EXPECT_EQ(coarse.found.solution.status, ContactStatus::converged);
  EXPECT_EQ(fine.found.solution.status, ContactStatus::converged);
  const Estimate<2> estimate = coarse.estimate(sweeps(2));
  EXPECT_EQ(estimate.reason, "");
  const BoundByReference found = bound_by_reference(
      coarse.problem, estimate, fine.problem, fine.found.solution.displacement);
  return found.errors / found.bound;
}

PushedBlock closed_block(Random& random) {
  return {irregular(4, 3, 6, 4, random),
          0,
          0,
          0,
          Multiplier::force,
          {{3, 0}, Matrix3d::Identity().rightCols(2), {0, 12, 3}}};
}

TEST(ToolWork, makes_an_equality_of_the_bound_where_all_is_closed) {
  // The motions differ by 2 %; without the work of the tool there is 1 % between both sides.
  Random random(4);
  PushedBlock block = closed_block(random);
  for (const int guided : {0, int{left}, int{right}}) {
    block.guided = guided;
    EXPECT_NEAR(part_of_bound(block, 2), 1, 1e-8);
  }
}

RC_GTEST_PROP(ToolWork, makes_e_a_bound_of_the_error_with_the_motion,
              (Random random)) {
  PushedBlock block = random_pushed(random);
  block.friction = 0;
  block.slip_bound = *rc::gen::element(0.0, 0.3, 2.0);
  block.tool.push[0] = 0;
  if (block.slip_bound == 0)
    block.tool.free = Matrix3d::Identity().rightCols(2);
  RC_ASSERT(part_of_bound(block, 2) <= 1 + 1e-10);
}

TEST(ToolWork, is_for_a_rigid_foundation) {
  Random random(2);
  const PushedBlock block = closed_block(random);
  Pushed pushed(block.on(block.mesh), block.tool);
  pushed.problem.line.opposite.resize(1, 1);
  EXPECT_TRUE(says(refusal([&] { pushed.estimate(); }), "a tool is a rigid"));
}

}  // namespace
}  // namespace ffcontact
