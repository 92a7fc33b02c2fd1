// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "support/random.hpp"
#include "support/solid_bodies.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact::test {

/// The condensed relation of a problem.
struct CondensedProblem {
  SurfaceTrace trace;
  CondensedStiffness stiffness;
  CondensedContact contact;

  explicit CondensedProblem(const SolidProblem& problem)
      : trace(surface_trace(problem.surface, problem.law, problem.system())),
        stiffness(problem.system(), trace.trace.kept_dofs),
        contact(condensed_contact(trace.trace, trace.primary, problem.b,
                                  stiffness)) {}
};

/// A block with moved vertices and any loads.
inline SolidProblem random_block(double mu, Random& random) {
  return block_problem(moved(brick({4, 2, 2}, {80, 40, 40}), 20, 0.15, random),
                       static_cast<BlockCase>(random() % 4), mu);
}

}  // namespace ffcontact::test
