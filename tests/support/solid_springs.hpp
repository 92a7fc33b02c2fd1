// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "support/random.hpp"
#include "support/solid_estimates.hpp"

/// Solids on springs.
namespace ffcontact::test {

/// K and u_0 at a point.
struct SolidSpring {
  Matrix3d K = Matrix3d::Zero();
  Vector3d rest = Vector3d::Zero();
};
using SolidSpringField = std::function<SolidSpring(const Vector3d& x)>;

/// Of random size and position, K of a rank.
inline Matrix3d random_stiffness(int rank, double scale, Random& random) {
  const MatrixXd root = random_matrix(3, rank, random);
  Matrix3d K = scale * root * root.transpose();
  if (rank == 3) K += 0.1 * scale * Matrix3d::Identity();
  return K;
}

/// On the faces of a side, at their points.
inline void put_springs(const SolidMesh& mesh, int side,
                        const SolidSpringField& field,
                        BoundarySprings<3>& springs) {
  if (springs.empty()) springs = BoundarySprings<3>(mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    if (mesh.boundary_label[b] != side) continue;
    const Matrix3d corners = mesh.vertices(Eigen::all, mesh.boundary.col(b));
    for (int q = 0; q < springs.points; ++q) {
      const SolidSpring at = field(corners * FacetQuadrature<3>::hats(q));
      springs.stiffness.block<6, 1>(6 * q, b) << at.K(0, 0), at.K(1, 0),
          at.K(2, 0), at.K(1, 1), at.K(2, 1), at.K(2, 2);
      springs.rest.block<3, 1>(3 * q, b) = at.rest;
    }
  }
}

/// Adds the springs to the stiffness and to the loads, as int2d does.
inline void assemble(const BoundarySprings<3>& springs, SolidProblem& problem) {
  using Quadrature = FacetQuadrature<3>;
  const SolidMesh& mesh = problem.mesh;
  const VectorXd none = VectorXd::Zero(problem.b.size());
  problem.b += boundary_forces<3>(mesh, spring_moments<3>(mesh, springs, none));
  MatrixXd added = MatrixXd::Zero(none.size(), none.size());
  for (Index b = 0; b < mesh.boundary.cols(); ++b)
    for (int q = 0; q < springs.points && springs.on(b); ++q)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const Vector3d phi = Quadrature::hats(q);
          added.block<3, 3>(3 * mesh.boundary(i, b), 3 * mesh.boundary(j, b)) +=
              boundary_measure(mesh, b) * Quadrature::weights[q] * phi[i] *
              phi[j] * springs.stiffness_at(q, b);
        }
  problem.A += RowMatrix(added.sparseView());
}

inline Estimate<3> estimate(const SolidProblem& problem,
                            const ContactSolution<3>& solution,
                            const BoundarySprings<3>& springs,
                            const RelaxationSettings& settings = {}) {
  SolvedBody<3> body = solved_solid(problem, solution);
  body.springs = springs;
  return estimate_error(topology_of(problem.mesh), problem.surface,
                        problem.system(), body, {settings});
}

}  // namespace ffcontact::test
