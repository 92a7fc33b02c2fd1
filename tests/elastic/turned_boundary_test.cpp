// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/turned_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "ffcontact/elastic/stiffness.hpp"
#include "support/irregular_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

template <int d>
RowMatrix unit_stiffness(const SimplexMesh<d>& mesh) {
  return stiffness(mesh,
                   HookeTensors<d>(mesh.cell_count(), isotropic<d>(1, 1)));
}

template <int d>
double share(const SimplexMesh<d>& mesh, RowMatrix K) {
  const VectorXd load = VectorXd::Zero(K.rows());
  return share_resisting_rotation(mesh, elastic_system(std::move(K), load, d),
                                  0, mesh.vertex_count());
}

template <int d>
void is_none_of_the_mesh_of_the_matrix(Random& random) {
  SimplexMesh<d> mesh = irregular_body<d>(random);
  mesh.vertices *= std::pow(10, *real(-9, 9));
  RC_ASSERT(share(mesh, unit_stiffness(mesh)) == 0);
}
PROPERTY_IN_BOTH_DIMENSIONS(TurnedBoundary, is_none_of_the_mesh_of_the_matrix)

template <int d>
void is_most_of_a_mesh_that_was_moved(Random& random) {
  SimplexMesh<d> mesh = irregular_body<d>(random);
  const RowMatrix K = unit_stiffness(mesh);
  mesh.vertices.row(d - 1) *= *rc::gen::element(0.5, 0.8, 1.25, 2.0);
  RC_ASSERT(share(mesh, K) > 0.6);
}
PROPERTY_IN_BOTH_DIMENSIONS(TurnedBoundary, is_most_of_a_mesh_that_was_moved)

template <int d>
void asks_none_that_others_hold(Random& random) {
  SimplexMesh<d> mesh = irregular_body<d>(random);
  RowMatrix K = unit_stiffness(mesh);
  K.diagonal() *= 1.001;  // springs
  mesh.vertices.row(0) *= 2;
  RC_ASSERT(share(mesh, K) == 0);
}
PROPERTY_IN_BOTH_DIMENSIONS(TurnedBoundary, asks_none_that_others_hold)

}  // namespace
}  // namespace ffcontact
