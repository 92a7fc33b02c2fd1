// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/pairing/common_refinement.hpp"
#include "support/bodies.hpp"

/// Bodies cut so that their traces match.
namespace ffcontact::test {

/// A body on a larger one whose vertices are at other places, with its left side on a
/// rigid foundation.
struct CutBodies {
  Bodies two;
  CommonRefinement refinement;

  explicit CutBodies(std::mt19937& random)
      : two(bodies({shifted(with_random_rows(3, 2, 3, 2, random), {1, 2}),
                    with_random_rows(5, 2, 5, 2, random)},
                   {material(1000, 0.3), material(200, 0.2)},
                   {{0, bottom, 1, top}})) {
    Problem& problem = two.problem;
    const ContactLine foundation =
        contact_line(problem.mesh, problem.edges, {two.label(0, left)});
    problem.line = joined_contact<2>({problem.line, foundation});
    problem.law.friction = everywhere(problem.line, 0);
    problem.law.gap = everywhere(problem.line, 0);
    refinement = common_refinement(problem.mesh, problem.edges, problem.line);
  }
  const Mesh& mesh() const { return two.problem.mesh; }
  const Edges& edges() const { return two.problem.edges; }
  const ContactLine& line() const { return two.problem.line; }
};

}  // namespace ffcontact::test
