// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/face_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ffcontact/estimate/error/face_fields.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

constexpr double mu = 0.4;

/// Three directions that turn by up to 1 from each other.
Matrix3Xd random_normals(Random& random) {
  const Vector3d n = random_vector(3, random).normalized();
  Matrix3Xd normals(3, 3);
  for (int k = 0; k < 3; ++k)
    normals.col(k) =
        (n + 0.5 * random_vector(3, random).normalized()).normalized();
  return normals;
}

/// r_n <= 0 and m across n with |m| <= mu |r_n| at the corners, there at the bound.
BentTraction random_traction(const Matrix3Xd& normals, Random& random) {
  BentTraction r{normals, -random_vector(3, random).cwiseAbs().transpose(),
                 Matrix3Xd(3, 3)};
  for (int k = 0; k < 3; ++k) {
    const Vector3d n = normals.col(k), any = random_vector(3, random);
    r.turned.col(k) = mu * r.pressing[k] * n.cross(any).normalized();
  }
  return r;
}

FaceMotion random_motion(const Matrix3Xd& normals, Random& random) {
  return {normals, random_matrix(3, 3, random), random_matrix(3, 3, random),
          random_vector(3, random).transpose()};
}

Vector3d random_place(Random& random) {
  const Vector3d place = random_vector(3, random).cwiseAbs();
  return place / place.sum();
}

RC_GTEST_PROP(BentTraction, is_in_the_cone_at_every_place, (Random random)) {
  const BentTraction traction = random_traction(random_normals(random), random);
  const QuadraticOnFace quadratic = along_axes(traction);
  for (int k = 0; k < 100; ++k) {
    const Vector3d place = random_place(random), n = traction.normal * place,
                   m = traction.turned * place, r = value_at(quadratic, place);
    const double rn = traction.pressing * place;
    RC_ASSERT((r - rn * n - n.cross(m)).norm() < 1e-15);
    const Vector3d along = n.normalized();
    const double pressed = r.dot(along);
    RC_ASSERT(pressed <= 0);
    RC_ASSERT((r - pressed * along).norm() <= -mu * pressed + 1e-15);
  }
}

RC_GTEST_PROP(BentTraction, of_one_direction_is_linear, (Random random)) {
  Matrix3Xd normals = random_normals(random);
  normals = normals.col(0).eval().replicate(1, 3);
  const BentTraction traction = random_traction(normals, random);
  Matrix3d corners;
  for (int k = 0; k < 3; ++k)
    corners.col(k) = value_at(along_axes(traction), Vector3d::Unit(k));
  RC_ASSERT((along_axes(traction) - raised(corners)).norm() < 1e-15);
}

/// The integrals of costs by quadrature, that of the slip's length by a fine one.
RC_GTEST_PROP(FaceCosts, are_integrals, (Random random)) {
  const FaceMotion motion = random_motion(random_normals(random), random);
  const FaceCosts costs = face_costs(motion, {0, 1, 2}, 0);
  Vector3d depth = Vector3d::Zero(), friction = depth;
  Matrix3d slip = Matrix3d::Zero();
  for (const auto& [at, weight] : points_of_triangle()) {
    depth += weight * motion.depth_at(at) * at;
    slip += weight * motion.slip_at(at) * at.transpose();
  }
  RC_ASSERT((costs.depth - depth).norm() < 1e-15);
  RC_ASSERT((costs.slip - slip).norm() < 1e-15);
  constexpr int parts = 20;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j) {
      const Vector3d middle =
          Vector3d(3 * i + 1, 3 * j + 1, 3 * (parts - i - j) - 2) /
          (3.0 * parts);
      friction += motion.slip_at(middle).norm() * middle / (parts * parts);
      if (i + j + 1 >= parts) continue;
      const Vector3d turned =
          Vector3d(3 * i + 2, 3 * j + 2, 3 * (parts - i - j) - 4) /
          (3.0 * parts);
      friction += motion.slip_at(turned).norm() * turned / (parts * parts);
    }
  RC_ASSERT((costs.friction - friction).minCoeff() > -1e-3);
}

/// Whatever is in the cone and clear at its corners and sides.
RC_GTEST_PROP(FaceCosts, are_not_negative_in_the_cone, (Random random)) {
  const Matrix3Xd normals = random_normals(random);
  const BentTraction r = random_traction(normals, random);
  FaceMotion motion = random_motion(normals, random);
  for (int pass = 0; pass < 20; ++pass)
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const double depth =
          std::max(depth_between(motion, k, l, pass > 0),
                   std::max({0.0, motion.depth(k), motion.depth(l)}));
      motion.jump.col(k) -= depth * normals.col(k);
      motion.jump.col(l) -= depth * normals.col(l);
    }
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    RC_ASSERT(motion.depth(k) <= 1e-15);
    RC_ASSERT(depth_between(motion, k, l, true) < 1e-14);
  }
  RC_ASSERT(deepest_on(motion, {0, 1, 2}) < 1e-14);
  const Eigen::RowVector3d bound = -mu * r.pressing;
  BetweenNodes found;
  note({r, bound}, motion, normals, 0, found);
  RC_ASSERT(found.negative < 1e-14);
  const FaceCosts costs = face_costs(motion, {0, 1, 2}, 0);
  RC_ASSERT(bound.dot(costs.friction) + r.pressing.dot(costs.depth) -
                r.turned.cwiseProduct(costs.slip).sum() >
            -1e-14);
}

RC_GTEST_PROP(FaceMotion, deepest_is_that_of_all_places, (Random random)) {
  const FaceMotion motion = random_motion(random_normals(random), random);
  constexpr int parts = 60;
  double expected = 0;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j)
      expected = std::max(
          expected, motion.depth_at(Vector3d(i, j, parts - i - j) / parts));
  const double found = deepest_on(motion, {0, 1, 2});
  RC_ASSERT(found >= expected - 1e-15);
  RC_ASSERT(found <= expected + 2e-3);
  const int corner = deepest_corner(motion, {0, 1, 2});
  for (int k = 0; k < 3; ++k)
    RC_ASSERT(motion.depth(k) <= motion.depth(corner));
}

}  // namespace
}  // namespace ffcontact
