// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "support/estimates.hpp"

/// Problems with initial strains and stresses.
namespace ffcontact::test {

/// sigma0 - C eps0 at a point, Voigt.
using InitialField = std::function<Vector3d(const Vector2d&)>;

inline LinearStresses<2> at_vertices(const Mesh& mesh,
                                     const InitialField& tau) {
  Matrix<double, 9, Dynamic> values(9, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 3; ++k)
      values.block<3, 1>(3 * k, t) = tau(mesh.corner(t, k));
  return LinearStresses<2>::of_values(values);
}

/// Takes int tau0 : eps(phi) off the loads.
inline void add_initial_stress(Problem& problem, const LinearStresses<2>& tau) {
  const Mesh& mesh = problem.mesh;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const Matrix<double, 2, 3> gradients = hat_gradients(mesh, t);
    for (int k = 0; k < 3; ++k)
      problem.b.segment<2>(2 * mesh.cells(k, t)) -=
          signed_area(mesh, t) * traction(tau.mean.col(t), gradients.col(k));
  }
}

inline SolvedBody<2> solved_body(const Problem& problem,
                                 const ContactSolution<2>& solution,
                                 const LinearStresses<2>& tau) {
  SolvedBody<2> body = solved_body(problem, solution);
  body.initial = tau;
  return body;
}

inline Estimate<2> estimated(const Problem& problem,
                             const ContactSolution<2>& solution,
                             const LinearStresses<2>& tau,
                             const EstimateSettings<2>& settings = {}) {
  return estimate_error(topology_of(problem.mesh), problem.line,
                        problem.system(), solved_body(problem, solution, tau),
                        settings);
}

}  // namespace ffcontact::test
