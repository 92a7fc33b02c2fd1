// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/difference_loads.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(BoundaryLoads, replace_those_of_known_tractions_alone,
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
  for (int e = 0; e < edges.count(); ++e)
    for (int c = 0; c < 4; ++c)
      if (boundary.known(c % 2, e)) mixed(c, e) = boundary.moments(c, e);

  const Matrix3Xd stress = random_matrix(3, mesh.cell_count(), random);
  EdgeLoadsOfAll loads = difference_loads(mesh, edges, others, stress);
  put_boundary_loads(mesh, edges, boundary, stress, loads);
  RC_ASSERT(loads == difference_loads(mesh, edges, mixed, stress));
}

}  // namespace
}  // namespace ffcontact
