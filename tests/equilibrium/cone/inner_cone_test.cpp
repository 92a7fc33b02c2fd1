// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/cone/inner_cone.hpp"

#include <cmath>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

double uniform(double low, double high, std::mt19937& random) {
  return Uniform{low, high}(random);
}

/// A cone of any kind, a traction in it, on its side in every other case, and the
/// direction of a ray, that of the traction in some.
struct AnyCone {
  FrictionCone cone;
  Vector3d present = Vector3d::Zero();
  Vector2d direction;

  explicit AnyCone(std::mt19937& random) {
    const int kind = static_cast<int>(random() % 4);
    if (kind == 1) cone.cohesion = uniform(0.1, 1, random);
    if (kind >= 2) cone.friction = uniform(0.1, 1, random);
    if (kind == 3) cone.limit = uniform(0.1, 1, random);
    const double angle = uniform(-4, 4, random),
                 share = random() % 2 ? 1 : uniform(0, 1, random);
    present[0] = random() % 4 ? -uniform(0, 1, random) : 0;
    present.tail<2>() = share * cone.bound(present[0]) *
                        Vector2d(std::cos(angle), std::sin(angle));
    const double off[] = {0, 1e-12, -1e-4, 1e-2, uniform(-4, 4, random)};
    const double ray = angle + off[random() % 5];
    direction =
        random() % 8 ? Vector2d(std::cos(ray), std::sin(ray)) : Vector2d(0, 0);
  }
};

RC_GTEST_PROP(InnerCone, lies_in_the_cone, (Random random)) {
  const AnyCone any(random);
  const InnerCone inner = inner_cone(any.cone, any.present, any.direction, 1);
  for (int trial = 0; trial < 200; ++trial) {
    Vector3d r = random_vector(3, random);
    if (any.cone.frictionless()) r.tail<2>().setZero();
    if ((inner.C * r - inner.d).minCoeff() < 0) continue;
    RC_ASSERT(r[0] <= 0);
    RC_ASSERT(r.tail<2>().norm() <= any.cone.bound(r[0]) + 1e-14);
  }
}

RC_GTEST_PROP(InnerCone, holds_the_present_traction, (Random random)) {
  const AnyCone any(random);
  const InnerCone inner = inner_cone(any.cone, any.present, any.direction, 1);
  RC_ASSERT((inner.C * any.present - inner.d).minCoeff() > -1e-15);
  // by rays of its own, not by limits that give way
  for (Index row = 1; row < inner.d.size(); ++row) {
    const double limit = inner.C(row, 0) == 0 && any.cone.limit < 2
                             ? any.cone.limit
                             : any.cone.cohesion;
    RC_ASSERT(inner.d[row] > -limit - 1e-14);
  }
}

RC_GTEST_PROP(InnerCone, reaches_the_cone_on_its_rays, (Random random)) {
  AnyCone any(random);
  any.present.tail<2>() *= 0.5;
  const InnerCone inner = inner_cone(any.cone, any.present, any.direction, 1);
  const double angle = any.direction.isZero(0)
                           ? 0
                           : std::atan2(any.direction.y(), any.direction.x());
  for (int ray = 0; ray < InnerCone::rays; ++ray) {
    const double turned = angle + 2 * EIGEN_PI * ray / InnerCone::rays;
    Vector3d r(-0.7, 0, 0);
    r.tail<2>() =
        any.cone.bound(r[0]) * Vector2d(std::cos(turned), std::sin(turned));
    RC_ASSERT((inner.C * r - inner.d).minCoeff() > -1e-14);
  }
}

}  // namespace
}  // namespace ffcontact
