// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "support/random.hpp"
#include "support/solid_bodies.hpp"

/// Stacks of solids whose meshes do not match.
namespace ffcontact::test {

inline Vector3i random_cells(int least, int most, Random& random) {
  const auto drawn = [&] {
    return least + static_cast<int>(random() % (most - least + 1));
  };
  return {drawn(), drawn(), 1 + static_cast<int>(random() % 2)};
}

/// Bricks on (0, 3) x (0, 2), one on the other, whose meshes do not match.
inline SolidStack random_stack(int bodies, double friction, Random& random) {
  std::vector<SolidMesh> meshes;
  for (int k = 0; k < bodies; ++k)
    meshes.push_back(random_brick(random_cells(1, 4, random), {0, 0, -1.0 * k},
                                  {3, 2, 1}, random));
  return {meshes, friction};
}

/// On a smooth ground, between smooth walls.
inline void put_between_walls(SolidStack& stack) {
  for (int k = 0; k <= stack.last(); ++k) stack.guide(k);
  stack.problem.guide(stack.label(stack.last(), low_z), 2);
}

/// Stacks held below, pressed and moved in one of some ways.
inline SolidStack random_solids(double mu, Random& random) {
  SolidStack stack =
      random_stack(2 + static_cast<int>(random() % 2), mu, random);
  SolidProblem& problem = stack.problem;
  const auto drawn = [&](double low, double high) {
    return Uniform{low, high}(random);
  };
  const int top = stack.label(0, high_z),
            ground = stack.label(stack.last(), low_z);
  if (random() % 2) {
    const Vector3d shift(drawn(-1e-3, 1e-3), drawn(-1e-3, 1e-3),
                         drawn(-2e-3, 1e-3));
    problem.move(top, [&](const Vector3d& x) {
      return Vector3d(shift + 1e-3 * Vector3d(0, 0, x.x() - 1.5));
    });
  } else {
    problem.load(top, {0, 0, -drawn(2, 5)});
    stack.guide(0);
  }
  for (int k = 1; k < stack.last(); ++k) stack.guide(k);
  problem.move(ground, [](const Vector3d&) { return Vector3d::Zero(); });
  problem.load(stack.label(0, high_x), {drawn(-3, 1), drawn(-1, 1), 0});
  problem.load(stack.label(1, high_y), {0, drawn(-3, 1), 0});
  return stack;
}

}  // namespace ffcontact::test
