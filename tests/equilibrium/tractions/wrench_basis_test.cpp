// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "support/balanced_unknowns.hpp"
#include "support/cells.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(WrenchBasis, has_the_wrench_and_bars_without_one,
              (Random random)) {
  const Matrix3d x = random_matrix(3, 3, random);
  const Vector3d centre = x.rowwise().mean();
  const double size = std::sqrt(facet_vector(x).norm());
  RC_PRE(size > 0.3);
  const Matrix9d V = wrench_basis<3>(x);
  Matrix<double, 6, 9> wrench = Matrix<double, 6, 9>::Zero();
  for (int unknown = 0; unknown < 9; ++unknown)
    for (int i = 0; i < 3; ++i) {
      const Vector3d b = V.col(unknown).segment<3>(3 * i);
      wrench.col(unknown).head<3>() += b;
      wrench.col(unknown).tail<3>() += (x.col(i) - centre).cross(b) / size;
    }
  Matrix<double, 6, 9> expected = Matrix<double, 6, 9>::Zero();
  expected.leftCols<6>().setIdentity();
  RC_ASSERT((wrench - expected).norm() < 1e-11);
  // of one size, and orthogonal to the rest
  RC_ASSERT((V.rightCols<3>().colwise().norm().array() - std::sqrt(2.0))
                .abs()
                .maxCoeff() < 1e-12);
  RC_ASSERT((V.leftCols<6>().transpose() * V.rightCols<3>()).norm() < 1e-10);
}

/// What wrenches and modes on a tetrahedron's faces lack to balance, of the loads.
double imbalance(const Topology<3>& topology, int cell,
                 const CellVector<3>& x) {
  const std::array<Matrix9d, 4> bases = wrench_bases<3>(topology, cell);
  FacetLoads<3> loads;
  for (int k = 0; k < 4; ++k)
    loads.middleCols<3>(3 * k).reshaped() = bases[k] * x.segment<9>(9 * k);
  return out_of_balance<3>(corners_of(topology.mesh, cell), loads,
                           CellBodyLoads<3>::Zero())
             .norm() /
         (1 + loads.norm());
}

RC_GTEST_PROP(WrenchBasis, a_wrench_around_an_edge_balances_its_tetrahedra,
              (Random random)) {
  const Topology<3> topology = topology_of(irregular_solid(random));
  const auto& [mesh, faces, edges, stars] = topology;
  const Vector6d wrench = random_vector(6, random);
  for (int e = 0; e < edges.count(); e += 7) {
    Matrix<double, 9, Dynamic> unknowns =
        Matrix<double, 9, Dynamic>::Zero(9, faces.count());
    for (int k = edges.facet_start[e]; k < edges.facet_start[e + 1]; ++k)
      unknowns.col(edges.facet[k])
          << wrench_shift<3>(topology, edges.facet[k], e).times(wrench),
          random_vector(3, random);
    for (int t = 0; t < mesh.cell_count(); ++t)
      RC_ASSERT(imbalance(topology, t, unknowns_at<3>(faces, unknowns, t)) <
                1e-12);
  }
}

RC_GTEST_PROP(WrenchBasis, the_wrench_on_one_face_balances_the_others,
              (Random random)) {
  const Topology<3> topology = topology_of(irregular_solid(random));
  for (int t = 0; t < topology.mesh.cell_count(); ++t) {
    const CellVector<3> x = balanced_unknowns(topology, t, t % 4, random);
    RC_ASSERT(imbalance(topology, t, x) < 1e-12);
  }
}

RC_GTEST_PROP(WrenchShift, is_one_matrix, (Random random)) {
  const WrenchShift<3> shift{random_vector(3, random), 0.7, -1};
  const Vector6d w = random_vector(6, random);
  RC_ASSERT((shift.matrix() * w - shift.times(w)).norm() < 1e-14);
  RC_ASSERT(
      (shift.matrix().transpose() * w - shift.transposed_times(w)).norm() <
      1e-14);
}

}  // namespace
}  // namespace ffcontact
