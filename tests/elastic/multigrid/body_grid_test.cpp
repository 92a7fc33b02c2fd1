// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/body_grid.hpp"

#include <gtest/gtest.h>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/linear/norms.hpp"
#include "support/random.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Two bricks one on the other, three vertices of the first follow two of the second in
/// directions of their own.
struct Followers {
  JoinedSolids joined = joined_mesh<3>(
      {brick({2, 1, 1}, {2, 1, 1}), brick({1, 1, 1}, {2, 1, 1})});
  SolidProblem problem{joined.mesh, 0, {joined.label(0, low_z)}};
  ElasticSystem system;
  VertexFrames<3> frames;
  int second = joined.first_vertex[1];

  Followers() : system(held()), frames(system) {
    Random random(1);
    for (int v = 0; v < 3; ++v) {
      const Matrix3d directions = random_matrix(3, 3, random);
      frames.put(v, Eigen::HouseholderQR<Matrix3d>(directions).householderQ());
      for (int w = 0; w < 2; ++w)
        frames.follow(v, second + w, random_matrix(3, 3, random));
    }
  }

  ElasticSystem held() {
    problem.move(joined.label(1, low_z),
                 [](const Vector3d&) { return Vector3d::Zero(); });
    return problem.system();
  }

  /// u = T y, column by column.
  MatrixXd T() const {
    const int dofs = system.dof_count();
    MatrixXd columns(dofs, dofs);
    for (int k = 0; k < dofs; ++k)
      columns.col(k) = frames.displacement(VectorXd::Unit(dofs, k));
    return columns;
  }
};

TEST(BodyGrid, is_the_stiffness_of_the_unknowns) {
  const Followers two;
  const MatrixXd T = two.T(),
                 K = T.transpose() * MatrixXd(two.system.stiffness) * T;
  const Grid<3, 3> grid =
      body_grid<3>(two.system, two.joined.mesh.vertices, two.frames);
  MatrixXd found = MatrixXd::Zero(K.rows(), K.cols());
  for (int v = 0; v < grid.A.rows(); ++v)
    for (int k = grid.A.pattern.begin(v); k < grid.A.pattern.end(v); ++k)
      found.block<3, 3>(3 * v, 3 * grid.A.pattern.column[k]) =
          grid.A.value[k].cast<double>();
  EXPECT_LT(max_norm(found - K), 1e-6 * max_norm(K));
}

TEST(BodyGrid, has_forces_that_do_the_work_of_those_on_displacements) {
  const Followers two;
  Random random(2);
  const VectorXd y = random_vector(two.system.dof_count(), random),
                 f = random_vector(two.system.dof_count(), random);
  EXPECT_NEAR(f.dot(two.frames.displacement(y)),
              two.frames.components(f).dot(y), 1e-12);
}

/// Where the directions of a vertex are not orthogonal, and some stand for nothing.
TEST(BodyGrid, has_the_unknowns_of_translations) {
  Random random(3);
  for (int held = 0; held < 3; ++held) {
    Matrix3d T = random_matrix(3, 3, random);
    T.rightCols(held).setZero();
    const Vector3d y = random_vector(3, random), u = T * y;
    const Vector3d found = motions_along<3>(T).leftCols<3>().cast<double>() * u;
    EXPECT_LT(max_norm((found - y).head(3 - held)), 1e-4);
    EXPECT_EQ(max_norm(found.tail(held)), 0);
  }
}

TEST(BodyGrid, parts_bodies_and_what_follows_others) {
  const Followers two;
  const NodeList part =
      body_grid<3>(two.system, two.joined.mesh.vertices, two.frames).part;
  for (int v = 0; v < count_of(part); ++v)
    for (int w = 0; w < v; ++w) {
      const bool same_body = (v < two.second) == (w < two.second),
                 same_kind = (v < 3) == (w < 3);
      EXPECT_EQ(part[v] == part[w], same_body && same_kind);
    }
}

}  // namespace
}  // namespace ffcontact
