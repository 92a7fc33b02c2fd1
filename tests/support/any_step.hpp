// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/newton/surface_step.hpp"
#include "support/condensed_blocks.hpp"

namespace ffcontact::test {

/// The condensed relation of a block with planes of symmetry, and any states of its nodes.
struct AnyStep : CondensedProblem {
  NaturalMap map;
  std::vector<NodeState> states;
  ContactRows rows;

  AnyStep(const SolidProblem& problem, Random& random)
      : CondensedProblem(problem), map(contact, trace.held) {
    const int nodes = problem.surface.node_count();
    const NodalLaw law = nodal_law(problem.law, problem.surface);
    for (int i = 0; i < nodes; ++i)
      states.push_back(node_state(
          law.cone[i],
          Vector3d(Vector3d(-0.7, 0, 0) + Vector3d(random_vector(3, random)))));
    rows.v = 1e-3 * random_vector(3 * nodes, random);
    rows.P = random_vector(3 * nodes, random);
  }

  SurfaceEquations equations() const { return {trace.held, map, states}; }

  ContactRows exact() const {
    ContactRows next = rows;
    RefinedSolver solver;
    solve_surface_step(contact, equations(), next, solver);
    return next;
  }

  /// Of an answer that may be 0.
  double size_of(const ContactRows& answer) const {
    return std::max(answer.v.norm(), 1e-2 * rows.v.norm());
  }
};

}  // namespace ffcontact::test
