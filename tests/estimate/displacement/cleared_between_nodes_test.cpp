// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "support/problems.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A line with directions that turn by up to 57 degrees an edge, and a displacement that is
/// clear at its nodes, at every third one by nothing.
struct ClearAtNodes {
  Problem problem;
  VectorXd u;

  explicit ClearAtNodes(Random& random)
      : problem(body(rotated(irregular(5, 2, 5, 2, random), *real(-3, 3)),
                     material(1, 0))) {
    problem.line = turned_at_random(problem.line, 0.5, random);
    u = random_vector(2 * problem.mesh.vertices.cols(), random);
    VectorXd& gap = problem.law.gap;
    gap = contact_components(problem.line, u).row(0).transpose();
    for (int i = 0; i < gap.size(); ++i)
      if (random() % 3 > 0) gap[i] += *real(0, 0.3);
  }

  /// The largest w . n(s) - gap at 100 points an edge.
  double deepest(const VectorXd& displacement) const {
    double largest = 0;
    for (int e = 0; e < problem.line.edge_count(); ++e)
      for (int k = 0; k <= 100; ++k)
        largest = std::max(largest, motion_at(problem.line, problem.law.gap,
                                              displacement, e, k / 100.0)[0]);
    return largest;
  }
};

RC_GTEST_PROP(ClearedBetweenNodes, is_clear_and_slides_as_before,
              (Random random)) {
  const ClearAtNodes given(random);
  const auto& [mesh, edges, line, hooke, A, b, neumann, force, law] =
      given.problem;
  const VectorXd clear = cleared_between_nodes(line, law, given.u);
  RC_ASSERT(given.deepest(clear) < 1e-14);
  RC_ASSERT(deepest_node(line, law, clear).depth < 1e-14);
  const double depth = deepest_node(line, law, given.u).depth;
  RC_ASSERT(depth >= given.deepest(given.u) - 1e-15);
  RC_ASSERT(depth <= given.deepest(given.u) + 1e-3);
  RC_ASSERT((depth == 0) == (clear == given.u));
  const Matrix2Xd change = contact_components(line, clear - given.u);
  RC_ASSERT(change.row(0).maxCoeff() <= 0);
  RC_ASSERT(change.row(1).cwiseAbs().maxCoeff() < 1e-14);
}

RC_GTEST_PROP(ClearedBetweenNodes, moves_one_end_where_the_other_is_held,
              (Random random)) {
  const ClearAtNodes given(random);
  const ContactLine& line = given.problem.line;
  Flags prescribed(given.u.size(), 0);
  for (int i = 0; i < line.node_count(); i += 2)
    for (int c = 0; c < 2; ++c) prescribed[2 * line.vertex[i] + c] = 1;
  const VectorXd clear =
      cleared_between_nodes(line, given.problem.law, given.u, prescribed);
  RC_ASSERT(given.deepest(clear) < 1e-14);
  for (int i = 0; i < line.node_count(); i += 2)
    RC_ASSERT(clear.segment<2>(2 * line.vertex[i]) ==
              given.u.segment<2>(2 * line.vertex[i]));
}

}  // namespace
}  // namespace ffcontact
