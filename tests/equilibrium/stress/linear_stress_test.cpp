// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/linear_stress.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double rounding = 1e-12;

TEST(LinearStresses, have_their_values_at_the_vertices) {
  Random random(3);
  const Matrix<double, 9, Dynamic> values = random_matrix(9, 4, random);
  const LinearStresses<2> stresses = LinearStresses<2>::of_values(values);
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
  EXPECT_FALSE(LinearStresses<2>::of_values(values).varies());
  values(4, 1) *= 1 + 1e-12;
  EXPECT_TRUE(LinearStresses<2>::of_values(values).varies());
}

TEST(LinearStresses, add_up_whichever_of_them_vary) {
  Random random(4);
  const LinearStresses<2> constant(random_matrix(3, 2, random)),
      varying = LinearStresses<2>::of_values(random_matrix(9, 2, random));
  const auto value = [](const LinearStresses<2>& s) -> Matrix3d {
    return s.empty() ? Matrix3d::Zero() : s.at_vertices(1);
  };
  for (const LinearStresses<2>& a : {LinearStresses<2>(), constant, varying})
    for (const LinearStresses<2>& b : {LinearStresses<2>(), constant, varying})
      EXPECT_LT((value(a + b) - value(a) - value(b)).norm(), rounding);
}

/// With its edge loads and body loads the composite stress is that stress.
RC_GTEST_PROP(LinearStress, is_the_composite_stress_of_its_loads,
              (Random random)) {
  const Mesh mesh = irregular(3, 2, 4, 3, random);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const CellCorners<2> corners = corners_of(mesh, t);
    const Matrix3d s = random_matrix(3, 3, random);
    const FacetLoads<2> loads = loads_of_stress<2>(corners, s);
    const SubcellStress<2> composite =
        composite_stress<2>(corners, loads, balancing_body_loads<2>(loads));
    RC_ASSERT((composite - subcell_values<2>(s)).norm() <
              1e-10 * composite.norm());
  }
}

/// What is left of zero edge moments is minus the stress, whether it varies or not.
RC_GTEST_PROP(DifferenceLoads, take_the_loads_of_a_linear_stress_off,
              (Random random)) {
  const Topology<2> topology = topology_of(irregular(3, 2, 4, 3, random));
  const Mesh& mesh = topology.mesh;
  const FacetColumns<2> none =
      FacetColumns<2>::Zero(4, topology.facets.count());
  const Matrix3Xd constant = random_matrix(3, mesh.cell_count(), random);
  const LinearStresses<2> varying =
      LinearStresses<2>::of_values(random_matrix(9, mesh.cell_count(), random));
  for (const LinearStresses<2>& s : {LinearStresses<2>(constant), varying}) {
    const LoadedFacets<2> loaded{topology, {}, {}, {}, s};
    for (int t = 0; t < mesh.cell_count(); ++t) {
      const FacetLoads<2> own =
          loads_of_stress<2>(corners_of(mesh, t), s.at_vertices(t));
      RC_ASSERT((difference_loads<2>(loaded, none, t) + own).norm() <
                rounding * own.norm());
    }
  }
}

}  // namespace
}  // namespace ffcontact
