// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/multiplier_weight.hpp"

#include <gtest/gtest.h>

#include "support/problems.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(MultiplierWeight, weight_is_the_mass_for_pressures_and_one_for_forces) {
  const ContactLine line = example_1(Multiplier::force, 2).line;
  EXPECT_EQ(MatrixXd(weight_matrix(Multiplier::pressure, line)),
            MatrixXd(contact_mass(line)));
  EXPECT_EQ(MatrixXd(weight_matrix(Multiplier::force, line)),
            MatrixXd::Identity(5, 5));
}

RC_GTEST_PROP(MultiplierWeight,
              weighted_multipliers_are_the_load_of_the_vector_density,
              (Random random)) {
  Mesh mesh = irregular(4, 3, 4, 3, random);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices(1, v) -=
        0.1 * mesh.vertices(0, v) * (4 - mesh.vertices(0, v));
  const ContactLine line = contact_line(mesh, edges_of(mesh), {bottom, left});
  const VectorXd P = random_vector(2 * line.node_count(), random);
  const auto vector_at = [&](int i) -> Vector2d {
    return P[2 * i] * line.normal.col(i) + P[2 * i + 1] * line.tangent(i);
  };
  Matrix2Xd load =
      // int (sum of P_j psi_j) psi_i, vector by vector
      Matrix2Xd::Zero(2, line.node_count());
  for (int e = 0; e < line.edge_count(); ++e)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        load.col(line.edge_node(a, e)) +=
            line.length[e] / (a == b ? 3 : 6) * vector_at(line.edge_node(b, e));
  const VectorXd weighted = weight_of_rows(Multiplier::pressure, line) * P;
  for (int i = 0; i < line.node_count(); ++i) {
    const Vector2d force = weighted[2 * i] * line.normal.col(i) +
                           weighted[2 * i + 1] * line.tangent(i);
    RC_ASSERT((force - load.col(i)).norm() < 1e-13);
  }
}

}  // namespace
}  // namespace ffcontact
