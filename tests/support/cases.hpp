// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "support/problems.hpp"
#include "support/random.hpp"

/// Random contact problems, kept as data so that they can be scaled, mirrored, rotated
/// and renumbered.
namespace ffcontact::test {

enum class Support {
  clamped_top,
  moved_top,        ///< clamped, with a displacement that presses and shears
  symmetric_right,  ///< only contact holds the body vertically
};

struct Case {
  Mesh mesh;  ///< a rectangle 6 x 4 by its labels, in contact at the bottom
  Support support = Support::clamped_top;
  Multiplier multiplier = Multiplier::force;
  double mu = 0, nu = 0.3;
  Vector2d on_left{0, 0}, on_right{0, 0}, on_top{0, 0};  ///< tractions [MPa]
  Vector2d in_body{0, 0};                                ///< [N/mm^3]
  Vector2d top_motion{0, 0};                             ///< [mm]
};

inline std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << "support " << static_cast<int>(c.support) << ", multiplier "
             << static_cast<int>(c.multiplier) << ", mu " << c.mu << ", nu "
             << c.nu << ", left " << c.on_left.transpose() << ", right "
             << c.on_right.transpose() << ", top " << c.on_top.transpose()
             << ", body " << c.in_body.transpose() << ", motion "
             << c.top_motion.transpose() << ", " << c.mesh.vertex_count()
             << " vertices";
}

inline Problem problem_of(const Case& c) {
  Problem problem = body(c.mesh, material(1000, c.nu));
  add_traction(problem, left, c.on_left);
  add_traction(problem, top, c.on_top);
  if (c.support != Support::symmetric_right)
    add_traction(problem, right, c.on_right);
  add_body_force(problem, c.in_body);
  if (c.support == Support::symmetric_right)
    prescribe(problem, right, 0);
  else
    clamp(problem, top, [&](const Vector2d&) { return c.top_motion; });
  set_friction(problem, c.mu);
  problem.law.multiplier = c.multiplier;
  return problem;
}

inline Vector2d flipped(const Vector2d& x) { return {-x.x(), x.y()}; }

/// Applies a linear map to the mesh's image and to all loads.
template <class Map>
Case mapped(Case c, const Mesh& image, Map&& map) {
  c.mesh = image;
  for (Vector2d* load :
       {&c.on_left, &c.on_right, &c.on_top, &c.in_body, &c.top_motion})
    *load = map(*load);
  return c;
}

inline Case mirrored(const Case& c) {
  return mapped(c, mirrored(c.mesh), flipped);
}

inline Case scaled(const Case& c, double factor) {
  return mapped(c, c.mesh,
                [=](const Vector2d& x) -> Vector2d { return factor * x; });
}

/// For supports that prescribe both components.
inline Case rotated(const Case& c, double angle) {
  const Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return mapped(c, rotated(c.mesh, angle),
                [&](const Vector2d& x) -> Vector2d { return R * x; });
}

inline rc::Gen<Vector2d> vector_in(double x, double y) {
  return rc::gen::apply([](double a, double b) { return Vector2d(a, b); },
                        real(-x, x), real(-y, y));
}

/// Loads of about 1 MPa on an irregular mesh; where only contact holds the body, the top
/// is pressed by more than all tractions can lift.
inline rc::Gen<Case> random_case(double largest_friction) {
  return rc::gen::exec([=] {
    Case c;
    Random random = *rc::gen::arbitrary<Random>();
    c.mesh = irregular(*rc::gen::inRange(2, 9), *rc::gen::inRange(2, 6), 6, 4,
                       random);
    c.support = *rc::gen::element(Support::clamped_top, Support::moved_top,
                                  Support::symmetric_right);
    c.multiplier = *rc::gen::element(Multiplier::force, Multiplier::pressure);
    c.mu = *real(0, largest_friction);
    c.nu = *real(0, 0.45);
    c.on_left = *vector_in(1, 1);
    c.on_right = *vector_in(1, 1);
    c.on_top = *vector_in(1, 1) - Vector2d(0, 3);
    c.in_body = *vector_in(0.05, 0.05);
    if (c.support == Support::moved_top)
      c.top_motion = *vector_in(0.005, 0.005) - Vector2d(0, 0.002);
    return c;
  });
}

}  // namespace ffcontact::test
