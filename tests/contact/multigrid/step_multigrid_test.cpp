// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/step_multigrid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/linear/norms.hpp"
#include "support/solid_corners.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Steps of a problem whose nodes are open or not, and stick or slip along an axis.
struct Steps : ProblemUnknowns {
  StepMultigrid step{system, problem.mesh.vertices, unknowns};
  SharedRows shared{unknowns.shared};

  /// GMRES's products of a step to a residual of 1e-4.
  int products(const std::vector<NodeState>& states, Random& random) {
    const VectorXd none = VectorXd::Zero(3 * states.size());
    const NaturalMap map(0.5 * stiffness(),
                         VectorXi::LinSpaced(none.size(), 0, none.size() - 1),
                         trace.held);
    const SurfaceEquations equations(trace.held, map, states);
    shared.put(none);
    shared.put(equations, none);
    const VectorXd z = shared.z_of(none);
    VectorXd missed(system.dof_count() + z.size());
    missed << on_free_dofs(system, random_vector(system.dof_count(), random)),
        VectorXd::Zero(z.size());
    for (const int v : problem.surface.vertex)
      missed.segment<3>(3 * v).setZero();
    const int before = step.products();
    EXPECT_TRUE(step.change(equations, shared, missed, 1e-4).has_value());
    return step.products() - before;
  }

 private:
  /// Of the bodies at each row.
  VectorXd stiffness() const {
    VectorXd K = VectorXd::Ones(trace.held.size());
    unknowns.for_rows([&](int row, int) { K[row] = step.stiffness(row); });
    for (const SharedVertex& vertex : unknowns.shared)
      K(vertex.rows) = vertex.stiffness;
    return K;
  }
};

NodeState sticks() { return {}; }
NodeState opens() {
  NodeState state;
  state.open = state.slips = true;
  return state;
}
NodeState slips() {
  NodeState state;
  state.slips = true;
  state.e = Vector2d::UnitY();
  state.ratio = 0.1;
  return state;
}

std::vector<NodeState> states_of(const ContactSurface& surface,
                                 const NodeState& floor,
                                 const NodeState& wall) {
  std::vector<NodeState> states;
  for (int i = 0; i < surface.node_count(); ++i)
    states.push_back(std::abs(surface.normal(2, i)) > 0.5 ? floor : wall);
  return states;
}

/// Multigrid knows that the walls hold what slips on the floor.
TEST(StepMultigrid, needs_few_products_along_an_edge) {
  Random random(1);
  SolidProblem problem(brick({3, 40, 2}, {3, 40, 2}), 0, {low_z, low_x});
  problem.move(high_z, [](const Vector3d&) { return Vector3d::Zero(); });
  Steps steps{{problem}};
  for (const NodeState& floor : {opens(), slips(), sticks()})
    for (const NodeState& wall : {opens(), slips(), sticks()}) {
      const auto states = states_of(problem.surface, floor, wall);
      EXPECT_LE(steps.products(states, random), 8);
    }
}

/// And what the forces z do, which glue the floor to the walls.
TEST(StepMultigrid, needs_few_products_where_rows_couple) {
  Random random(1);
  const SolidCorner corner(2, 0, random, 6);
  Steps steps{{corner.problem}};
  const auto states = states_of(corner.problem.surface, sticks(), sticks());
  EXPECT_LE(steps.products(states, random), 65);
}

}  // namespace
}  // namespace ffcontact
