// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/linear_stress.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/tractions/difference_loads.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double rounding = 1e-12;

TEST(LinearStresses, have_their_values_at_the_vertices) {
  Random random(3);
  const Matrix<double, 9, Dynamic> values = random_matrix(9, 4, random);
  const LinearStresses stresses = LinearStresses::of_values(values);
  for (int t = 0; t < 4; ++t) {
    const Matrix3d expected = values.col(t).reshaped(3, 3),
                   variation = stresses.variation.col(t).reshaped(3, 3);
    EXPECT_LT((stresses.at_vertices(t) - expected).norm(), rounding);
    EXPECT_LT(variation.rowwise().sum().norm(), rounding);
  }
}

TEST(LinearStresses, that_vary_by_rounding_are_constant) {
  const Vector3d value(1, 2, 3);
  Matrix<double, 9, Dynamic> values = value.replicate<3, 2>();
  values(4, 1) *= 1 + 1e-15;
  EXPECT_FALSE(LinearStresses::of_values(values).varies());
  values(4, 1) *= 1 + 1e-12;
  EXPECT_TRUE(LinearStresses::of_values(values).varies());
}

TEST(LinearStresses, add_up_whichever_of_them_vary) {
  Random random(4);
  const LinearStresses constant(random_matrix(3, 2, random)),
      varying = LinearStresses::of_values(random_matrix(9, 2, random));
  const auto value = [](const LinearStresses& s) -> Matrix3d {
    return s.empty() ? Matrix3d::Zero() : s.at_vertices(1);
  };
  for (const LinearStresses& a : {LinearStresses(), constant, varying})
    for (const LinearStresses& b : {LinearStresses(), constant, varying})
      EXPECT_LT((value(a + b) - value(a) - value(b)).norm(), rounding);
}

/// With its edge loads and body loads the composite stress is that stress.
RC_GTEST_PROP(LinearStress, is_the_composite_stress_of_its_loads,
              (Random random)) {
  const Mesh mesh = irregular(3, 2, 4, 3, random);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const TriangleCorners corners = corners_of(mesh, t);
    const Matrix3d s = random_matrix(3, 3, random);
    const CompositeStress composite = composite_stress(
        corners, edge_loads(corners, s), balancing_loads(corners, s));
    RC_ASSERT((composite - composite_of(s)).norm() < 1e-10 * composite.norm());
  }
}

/// What is left of zero edge moments is minus the stress, whether it varies or not.
RC_GTEST_PROP(DifferenceLoads, take_the_loads_of_a_linear_stress_off,
              (Random random)) {
  const Mesh mesh = irregular(3, 2, 4, 3, random);
  const Edges edges = edges_of(mesh);
  const EdgeMoments none = EdgeMoments::Zero(4, edges.count());
  const Matrix3Xd constant = random_matrix(3, mesh.cell_count(), random);
  const LinearStresses varying =
      LinearStresses::of_values(random_matrix(9, mesh.cell_count(), random));
  for (const LinearStresses& s : {LinearStresses(constant), varying}) {
    const EdgeLoadsOfAll loads = difference_loads(mesh, edges, none, s);
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const EdgeLoads own = edge_loads(corners_of(mesh, t), s.at_vertices(t));
      RC_ASSERT((loads.col(t) + own).norm() < rounding * own.norm());
    }
  }
}

}  // namespace
}  // namespace ffcontact
