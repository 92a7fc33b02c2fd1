// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/body_loads.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// The work of the lumped loads of a force on a field is int of the interpolant of both.
template <int d>
double work_of_lumped(const SimplexMesh<d>& mesh, const VectorXd& force,
                      const VectorXd& field) {
  VectorXd b = VectorXd::Zero(field.size());
  add_body_loads(mesh, lumped_loads(mesh, force), b);
  return b.dot(field);
}

TEST(BodyLoads, a_constant_force_acts_on_all_of_the_volume) {
  const Mesh plane = rectangle(3, 2, 6, 4);
  const VectorXd up = Vector2d(1, 2).replicate(plane.vertex_count(), 1),
                 one = VectorXd::Ones(up.size());
  EXPECT_NEAR(work_of_lumped(plane, up, one), 24 * (1 + 2), 1e-12);
  const SolidMesh solid = brick({2, 3, 2}, {1, 2, 3});
  const VectorXd away = Vector3d(1, 2, 4).replicate(solid.vertex_count(), 1),
                 all = VectorXd::Ones(away.size());
  EXPECT_NEAR(work_of_lumped(solid, away, all), 6 * (1 + 2 + 4), 1e-12);
}

TEST(BodyLoads, a_linear_force_has_its_resultant) {
  const Mesh mesh = rectangle(4, 3, 6, 4);
  const VectorXd force = mesh.vertices.reshaped(),  // f = x
      one = VectorXd::Ones(force.size());
  const Vector2d middle(3, 2);
  EXPECT_NEAR(work_of_lumped(mesh, force, one), 24 * middle.sum(), 1e-12);
}

TEST(BodyLoads, volumes_are_those_of_the_cells_around) {
  const Mesh mesh = rectangle(1, 1, 2, 3);
  const VectorXd volumes = lumped_volumes(mesh);
  EXPECT_NEAR(volumes.sum(), 2 * 6, 1e-14);
  EXPECT_NEAR(volumes.minCoeff(), 1, 1e-14);
  EXPECT_NEAR(volumes.maxCoeff(), 2, 1e-14);
}

TEST(BodyLoads, no_columns_are_no_loads) {
  const Mesh mesh = rectangle(1, 1, 2, 3);
  VectorXd b = VectorXd::Ones(8);
  add_body_loads(mesh, BodyLoadsOfCells<2>(6, 0), b);
  EXPECT_EQ(b, VectorXd::Ones(8));
}

}  // namespace
}  // namespace ffcontact
