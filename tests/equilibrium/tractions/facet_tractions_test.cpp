// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "support/bodies.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(FacetTractions, replace_those_that_are_known_alone,
              (Random random)) {
  Problem problem = body(irregular(4, 3, 4, 3, random), material(1, 0.3));
  const auto& [mesh, edges] = std::tie(problem.mesh, problem.edges);
  prescribe(problem, right, 0);
  const Matrix2Xd none = Matrix2Xd::Zero(2, problem.line.edge_count());
  BoundaryTractions boundary =
      boundary_tractions(mesh, edges, prescribed_dofs(problem.A),
                         problem.neumann, problem.line, {none, none});
  boundary.moments = random_matrix(4, edges.count(), random);
  const EdgeMoments others = random_matrix(4, edges.count(), random);
  EdgeMoments mixed = others;
  put_known<2>(boundary, mixed);
  for (int e = 0; e < edges.count(); ++e)
    for (int c = 0; c < 4; ++c)
      RC_ASSERT(
          mixed(c, e) ==
          (boundary.known(c % 2, e) ? boundary.moments(c, e) : others(c, e)));
}

}  // namespace
}  // namespace ffcontact
