// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/checks/sliding_motions.hpp"
#include "support/arcs.hpp"
#include "support/problems.hpp"

/// Pins in bores, which nothing but the noise of coordinates keeps from turning.
namespace ffcontact::test {

constexpr double pin_radius = 10;

/// A pin that lies in a rigid bore without friction, pressed by its weight.
/// @param noise  of its coordinates [mm]
/// @param width  in parts of that of a round one
inline Problem pin(double noise, unsigned seed = 1, double width = 1) {
  constexpr double clearance = 0.05;
  Mesh mesh = arc_body(even_angles(-1.2, 1.2, 24), pin_radius);
  mesh.vertices.row(0) *= width;
  std::mt19937 random(seed);
  const Uniform shift{-noise, noise};
  for (double& x : mesh.vertices.reshaped()) x += shift(random);
  Problem problem = body(mesh, material(2e5, 0.3));
  problem.line = contact_line(mesh, problem.edges, {bottom},
                              BoundaryCurves(mesh, problem.edges));
  problem.law.friction = everywhere(problem.line, 0);
  problem.law.gap = clearance * (1 + problem.line.normal.row(1).array());
  add_body_force(problem, {0, -20});
  return problem;
}

inline MatrixXd sliding(const Problem& problem) {
  return rigid_motions(problem.mesh, problem.line, problem.law,
                       problem.system())
      .sliding;
}

/// Turns contact directions across what slides.
/// @return what balances the loads along it
inline BodyLoadsOfCells<2> held(Problem& problem) {
  const MatrixXd motions = sliding(problem);
  turn_across(motions, problem.line);
  return holding_loads(problem.mesh, motions, problem.b);
}

}  // namespace ffcontact::test
