// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/stress_terms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/linear/norms.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// |C| |c| (1/h + 1/h + sqrt(2)/h) of a motion c on right triangles of legs h, where
/// |c| = 5 and |C| = 5 on the stiffest.
TEST(StressTerms, of_a_motion_do_not_cancel) {
  const Mesh mesh = rectangle(3, 2, 1.5, 1);
  Hooke hooke(mesh.cell_count(), Matrix3d::Identity());
  hooke[7](1, 2) = hooke[7](2, 1) = -5;
  VectorXd u(2 * mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) u.segment<2>(2 * v) << 3, 4;
  EXPECT_NEAR(largest_stress_terms(mesh, hooke, u),
              5 * 5 * (2 + std::sqrt(2)) / 0.5, 1e-12);
}

/// Strains have engineering shear: a sum of two components.
RC_GTEST_PROP(StressTerms, bound_all_strains, (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const HookeTensors<3> hooke(mesh.cell_count(),
                              Matrix<double, 6, 6>::Identity());
  const VectorXd u = random_vector(3 * mesh.vertex_count(), random);
  const double terms = largest_stress_terms(mesh, hooke, u);
  double most = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    most = std::max(most, max_norm(strain(mesh, u, t)));
  RC_ASSERT(most <= std::sqrt(2) * terms);
  RC_ASSERT(terms < 100 * most);
}

}  // namespace
}  // namespace ffcontact
