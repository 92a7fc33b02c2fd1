// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/random.hpp"
#include "support/solid_bodies.hpp"
#include "support/solid_problems.hpp"

namespace ffcontact::test {

/// A brick 3 x 2 x 2 on its side low_z, held or pressed in one of some ways.
inline SolidProblem random_problem(double mu, Random& random) {
  SolidProblem problem(irregular_solid(random), mu);
  const auto drawn = [&](double low, double high) {
    return Uniform{low, high}(random);
  };
  const int kind = static_cast<int>(random() % 4);
  if (kind < 2) {
    const Vector3d shift(drawn(-1e-3, 1e-3), drawn(-1e-3, 1e-3),
                         drawn(-2e-3, 1e-3));
    const Vector3d turn(drawn(-1e-3, 1e-3), drawn(-1e-3, 1e-3), 0);
    problem.move(high_z, [&](const Vector3d& x) {
      return Vector3d(shift + turn.cross(x - Vector3d(1.5, 1, 2)));
    });
  } else if (kind == 2) {
    problem.guide(low_x, 0);
    problem.guide(low_y, 1);
    problem.load(high_z, {0, 0, -drawn(1, 5)});
  } else {
    problem.load(high_z, {0, 0, -drawn(2, 5)});
    problem.guide(low_x, 0);
    problem.guide(low_x, 1);
  }
  problem.load(high_x, {drawn(-3, 1), drawn(-1, 1), 0});
  problem.load(high_y, {0, drawn(-3, 1), 0});
  return problem;
}

/// Gaps as large as displacements, friction that varies, and a step before.
inline void make_rough(SolidProblem& problem, Random& random) {
  const int nodes = problem.surface.node_count();
  problem.law.friction = random_vector(nodes, random).cwiseAbs();
  problem.law.gap = 1e-3 * random_vector(nodes, random).cwiseAbs();
  problem.law.previous = 1e-3 * random_matrix(2, nodes, random);
}

inline SolidProblem rough_problem(Random& random) {
  SolidProblem problem = random_problem(0, random);
  make_rough(problem, random);
  return problem;
}

/// Likewise rough, a body that nothing else holds.
inline SolidProblem resting_problem(Random& random) {
  SolidProblem problem(irregular_solid(random));
  const auto drawn = [&](double low, double high) {
    return Uniform{low, high}(random);
  };
  problem.load(high_z, {0, 0, -drawn(2, 5)});
  const double x = drawn(-1, 1), y = drawn(-1, 1);
  problem.load(high_x, {x, y, 0});
  problem.load(high_y, {0, drawn(-1, 1), 0});
  make_rough(problem, random);
  problem.law.friction *= drawn(0, 5);
  return problem;
}

}  // namespace ffcontact::test
