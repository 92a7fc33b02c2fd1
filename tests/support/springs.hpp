// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "support/estimates.hpp"

/// Bodies on springs.
namespace ffcontact::test {

/// K and u_0 at a point of an edge with this outward normal.
struct Spring {
  Matrix2d K = Matrix2d::Zero();
  Vector2d rest = Vector2d::Zero();
};
using SpringField = std::function<Spring(const Vector2d& x, const Vector2d& n)>;

/// On the edges of a label, at their Gauss points.
inline void put_springs(const Mesh& mesh, int label, const SpringField& field,
                        BoundarySprings<2>& springs) {
  if (springs.empty()) springs = BoundarySprings<2>(mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    if (mesh.boundary_label[b] != label) continue;
    const Vector2d first = mesh.vertices.col(mesh.boundary(0, b)),
                   along = mesh.vertices.col(mesh.boundary(1, b)) - first;
    for (int q = 0; q < 3; ++q) {
      const Spring at = field(first + FacetQuadrature<2>::hats(q)[1] * along,
                              turned_right(along.normalized()));
      springs.stiffness.block<3, 1>(3 * q, b) << at.K(0, 0), at.K(0, 1),
          at.K(1, 1);
      springs.rest.block<2, 1>(2 * q, b) = at.rest;
    }
  }
}

/// Adds the springs to the stiffness and to the loads, as int1d does.
inline void assemble(const BoundarySprings<2>& springs, Problem& problem) {
  const Mesh& mesh = problem.mesh;
  const VectorXd none = VectorXd::Zero(problem.b.size());
  problem.b += boundary_forces<2>(mesh, spring_moments<2>(mesh, springs, none));
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    if (!springs.on(b)) continue;
    const double length = (mesh.vertices.col(mesh.boundary(1, b)) -
                           mesh.vertices.col(mesh.boundary(0, b)))
                              .norm();
    for (int q = 0; q < 3; ++q)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          const Vector2d phi = FacetQuadrature<2>::hats(q);
          const Matrix2d K = length * FacetQuadrature<2>::weights[q] * phi[i] *
                             phi[j] * springs.stiffness_at(q, b);
          for (int c = 0; c < 4; ++c)
            problem.A.coeffRef(2 * mesh.boundary(i, b) + c % 2,
                               2 * mesh.boundary(j, b) + c / 2) +=
                K(c % 2, c / 2);
        }
  }
}

inline Estimate<2> estimated(const Problem& problem,
                             const ContactSolution<2>& solution,
                             const BoundarySprings<2>& springs,
                             const EstimateSettings<2>& settings = {}) {
  SolvedBody<2> body = solved_body(problem, solution);
  body.springs = springs;
  return estimate_error(topology_of(problem.mesh), problem.line,
                        problem.system(), body, settings);
}

}  // namespace ffcontact::test
