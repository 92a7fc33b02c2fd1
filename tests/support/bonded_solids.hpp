// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/problems.hpp"
#include "support/solid_stacks.hpp"

/// Solids that are glued to each other.
namespace ffcontact::test {

/// To a rigid foundation or to each other.
inline void bond(SolidProblem& problem) {
  problem.law = bonded_law<3>(problem.surface.node_count());
}

/// Bodies that are bonded one on the other.
inline SolidStack bonded_stack(const std::vector<SolidMesh>& bodies) {
  SolidStack stack(bodies, 0);
  bond(stack.problem);
  return stack;
}

/// A brick from a place on.
inline SolidMesh brick_at(const Vector3i& cells, const Vector3d& size,
                          const Vector3d& low) {
  SolidMesh mesh = brick(cells, size);
  mesh.vertices.colwise() += low;
  return mesh;
}

/// Bricks 3 x 2 x 1, the first one on the second.
inline SolidStack bonded_bricks(const Vector3i& upper, const Vector3i& lower) {
  return bonded_stack(
      {brick(upper, {3, 2, 1}), brick_at(lower, {3, 2, 1}, {0, 0, -1})});
}

/// Of random cells, with vertices inside of each side.
inline SolidStack random_bonded_bricks(Random& random) {
  const auto cells = [&] { return random_cells(2, 4, random); };
  return bonded_stack({random_brick(cells(), {0, 0, 0}, {3, 2, 1}, random),
                       random_brick(cells(), {0, 0, -1}, {3, 2, 1}, random)});
}

inline Vector3d linear_solid_field(const Vector3d& x) {
  return {1e-3 * x[0] + 2e-3 * x[2] + 0.01, 3e-3 * x[1] - 0.5e-3 * x[0],
          2e-3 * x[2] - 1e-3 * x[1]};
}

/// The linear field above and below two bodies, and its tractions beside them.
inline void prescribe_uniform_stress(SolidStack& two) {
  const double lambda = 13e3 * 0.2 / 0.72, G = 13e3 / 2.4;
  Matrix3d gradient;
  for (int c = 0; c < 3; ++c)
    gradient.col(c) = linear_solid_field(Vector3d::Unit(c)) -
                      linear_solid_field(Vector3d::Zero());
  const Matrix3d stress = lambda * gradient.trace() * Matrix3d::Identity() +
                          G * (gradient + Matrix3d(gradient.transpose()));
  for (const int body : {0, 1}) {
    two.problem.load(two.label(body, low_x), -stress.col(0));
    two.problem.load(two.label(body, high_x), stress.col(0));
    two.problem.load(two.label(body, low_y), -stress.col(1));
    two.problem.load(two.label(body, high_y), stress.col(1));
  }
  two.problem.move(two.label(0, high_z), linear_solid_field);
  two.problem.move(two.label(1, low_z), linear_solid_field);
}

/// They stand on a support and are pulled upwards and aside.
inline void pull(SolidStack& stack) {
  stack.problem.load(stack.label(0, high_z), {3, 1, 7});
  stack.problem.move(stack.label(stack.last(), low_z),
                     [](const Vector3d&) { return Vector3d::Zero(); });
}

}  // namespace ffcontact::test
