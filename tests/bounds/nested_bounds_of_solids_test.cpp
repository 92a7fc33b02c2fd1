// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ffcontact/bounds/quantity_bounds.hpp"
#include "support/bounded_solids.hpp"
#include "support/random.hpp"
#include "support/solid_bodies.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A random block, law and quantity on meshes of Kuhn's bricks, which are nested.
class RandomSolid {
 public:
  explicit RandomSolid(Random& random)
      : map_(Matrix3d::Identity() + 0.3 * random_matrix(3, 3, random)),
        shift_(1e-3 * random_vector(3, random)),
        on_x_(5 * random_vector(3, random)),
        on_y_(5 * random_vector(3, random)),
        law_(1e-4 * random_matrix(3, 3, random)),
        slip_bound_(*rc::gen::inRange(0, 3) * *real(0, 2)),
        turn_(*rc::gen::inRange(0, 2) * 0.1 * random_vector(2, random)),
        spring_{*rc::gen::inRange(0, 2) * random_stiffness(3, 1e3, random),
                1e-3 * random_vector(3, random)},
        kind_(static_cast<int>(random() % 3)),
        w_(random_vector(3, random)),
        M_(random_vector(6, random)) {
    map_.row(2).head<2>().setZero();
    shift_.z() = -std::abs(shift_.z());
  }

  SolidWithAnswer on(int cells) const {
    SolidMesh mesh = brick({2 * cells, cells, cells}, {2, 1, 1});
    mesh.vertices = (map_ * mesh.vertices).eval();
    SolidProblem problem(mesh);
    problem.move(high_z, [&](const Vector3d&) { return shift_; });
    problem.load(high_x, on_x_);
    problem.load(high_y, on_y_);
    ContactLaw<3>& law = problem.law;
    if (slip_bound_ > 0) law.slip_bound = on_all_nodes(problem, slip_bound_);
    Matrix3Xd place = mesh.vertices(Eigen::all, problem.surface.vertex);
    place.row(2).setOnes();
    law.gap = (law_.row(0) * place).transpose();
    law.previous = law_.bottomRows<2>() * place;
    turn(problem);
    BoundarySprings<3> springs;
    if (!spring_.K.isZero(0)) {
      put_springs(
          mesh, low_x, [&](const Vector3d&) { return spring_; }, springs);
      assemble(springs, problem);
    }
    return SolidWithAnswer(problem, springs);
  }

  Quantity<3> quantity(const SolidWithAnswer& solved) const {
    const SolidMesh& mesh = solved.problem.mesh;
    if (kind_ == 0) return on_label<3>(mesh, high_x, w_);
    if (kind_ == 1) return on_label<3>(mesh, low_z, w_);
    return in_cells(mesh, solved.body.hooke, w_, M_, [&](const Vector3d& x) {
      return Vector3d(map_.inverse() * x).x() < 1;
    });
  }

 private:
  /// The normals over the surface, with the same gap.
  void turn(SolidProblem& problem) const {
    if (turn_.isZero(0)) return;
    ContactSurface& surface = problem.surface;
    for (int i = 0; i < surface.node_count(); ++i) {
      const auto x = problem.mesh.vertices.col(surface.vertex[i]);
      const Vector3d along(turn_.x() * x.x(), turn_.y() * x.y(), 0);
      const double length = std::hypot(1, along.norm());
      surface.normal.col(i) = (surface.normal.col(i) + along) / length;
      problem.law.gap[i] /= length;
      problem.law.previous.col(i).setZero();
    }
  }

  Matrix3d map_;
  Vector3d shift_, on_x_, on_y_;
  Matrix3d law_;  ///< gap and load step before by 1, x and y
  double slip_bound_;
  Vector2d turn_;  ///< of the normals [1/mm]
  SolidSpring spring_;
  int kind_;
  Vector3d w_;
  VectorOf<6> M_;
};

RC_GTEST_PROP(NestedBoundsOfSolids, narrow_and_hold_references,
              (Random random)) {
  const RandomSolid solid(random);
  const auto bounds_on = [&](int cells) {
    const SolidWithAnswer solved = solid.on(cells);
    return solved.bounds(solid.quantity(solved));
  };
  const QuantityBounds wide = bounds_on(1), narrow = bounds_on(2);
  require_that_they_narrow(wide, narrow);
  const SolidWithAnswer finest = solid.on(4);
  require_that_they_hold(wide, narrow.value,
                         finest.value(solid.quantity(finest)));
}

/// Two bricks whose meshes match or do not, and a quantity of one of them.
class RandomBricks {
 public:
  explicit RandomBricks(Random& random)
      : above_(cells(random)),
        below_(random() % 2 ? cells(random) : above_),
        slip_bound_(*rc::gen::inRange(0, 3) * *real(0, 2)),
        shift_(1e-3 * random_vector(3, random) - Vector3d(0, 0, 1e-3)),
        on_side_(3 * random_vector(3, random)),
        kind_(random() % 3),
        w_(random_vector(3, random)) {}

  QuantityBounds bounds(int times) const {
    const SolidStack two = on(times);
    return SolidWithAnswer(two.problem).bounds(quantity(two));
  }
  /// l(u_h)
  double value(int times) const {
    const SolidStack two = on(times);
    return SolidWithAnswer(two.problem).value(quantity(two));
  }

 private:
  static Vector3i cells(Random& random) {
    return {1 + static_cast<int>(random() % 2),
            1 + static_cast<int>(random() % 2), 1};
  }

  SolidStack on(int times) const {
    SolidMesh upper = brick(times * above_, {2, 1, 1});
    upper.vertices.row(2).array() += 1;
    SolidStack stack({upper, brick(times * below_, {2, 1, 1})}, 0);
    SolidProblem& problem = stack.problem;
    if (slip_bound_ > 0)
      problem.law.slip_bound = on_all_nodes(problem, slip_bound_);
    problem.move(stack.label(0, high_z),
                 [&](const Vector3d&) { return shift_; });
    problem.move(stack.label(1, low_z),
                 [](const Vector3d&) { return Vector3d::Zero(); });
    problem.load(stack.label(1, high_x), on_side_);
    return stack;
  }

  Quantity<3> quantity(const SolidStack& two) const {
    const int label = kind_ == 0   ? two.label(0, high_x)
                      : kind_ == 1 ? two.label(0, low_z)
                                   : two.label(1, high_x);
    return on_label<3>(two.problem.mesh, label, w_);
  }

  Vector3i above_, below_;
  double slip_bound_;
  Vector3d shift_, on_side_;
  unsigned kind_;
  Vector3d w_;
};

RC_GTEST_PROP(NestedBoundsOfSolids, of_two_bodies_narrow_and_hold_references,
              (Random random)) {
  require_nested_bounds(RandomBricks(random), 1, 2, 4);
}

}  // namespace
}  // namespace ffcontact
