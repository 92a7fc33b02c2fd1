// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include "ffcontact/equilibrium/tractions/difference_loads.hpp"
#include "ffcontact/equilibrium/tractions/edge_moments.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "support/problems.hpp"

/// From a problem to its admissible fields.
namespace ffcontact::test {

/// The problems are small: two threads would only wait for each other. Tests of threads
/// set their own number.
inline const bool one_thread = (omp_set_num_threads(1), true);

/// int f phi_i of a body force that is constant on each triangle.
inline BodyLoadsOfAll body_loads(const Problem& problem) {
  BodyLoadsOfAll loads(6, problem.mesh.cells.cols());
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    loads.col(t) =
        (signed_area(problem.mesh, t) / 3 * problem.body_force.col(t))
            .replicate<3, 1>();
  return loads;
}

inline SolvedBody solved_body(const Problem& problem,
                              const ContactSolution& solution) {
  return {problem.hooke,     solution.displacement, solution.pressure,
          problem.law,       problem.neumann,       body_loads(problem),
          solution.stiffness};
}

inline EstimateSettings sweeps(int count,
                               Tractions tractions = Tractions::free) {
  EstimateSettings settings;
  settings.relaxation.sweeps = count;
  settings.tractions = tractions;
  return settings;
}

inline Estimate estimated(const Problem& problem,
                          const ContactSolution& solution,
                          const EstimateSettings& settings = {}) {
  return estimate_error(topology_of(problem.mesh), problem.line,
                        problem.system(), solved_body(problem, solution),
                        settings);
}

/// What star relaxation starts from: edge tractions in equilibrium with the contact
/// tractions of the solver.
struct Equilibrated {
  Topology topology;
  Matrix3Xd stress;  ///< C eps(u_h)
  BoundaryTractions boundary;
  EdgeMoments moments;
  BodyLoadsOfAll loads;
  EdgeLoadsOfAll difference;
};

inline Equilibrated equilibrated(const Problem& problem,
                                 const VectorXd& displacement,
                                 const ContactDensities& densities) {
  Equilibrated result;
  result.topology = topology_of(problem.mesh);
  result.stress = stresses(problem.mesh, problem.hooke, displacement);
  result.boundary = boundary_tractions(
      problem.mesh, problem.edges, prescribed_dofs(problem.A), problem.neumann,
      problem.line, densities);
  result.loads = body_loads(problem);
  require_balanced(problem.mesh, nodal_residual(result.topology, result.stress,
                                                result.loads, result.boundary));
  result.moments = equilibrated_moments(result.topology, result.stress,
                                        result.loads, result.boundary);
  result.difference = difference_loads(problem.mesh, problem.edges,
                                       result.moments, result.stress);
  return result;
}

inline Equilibrated equilibrated(const Problem& problem,
                                 const ContactSolution& solution) {
  return equilibrated(problem, solution.displacement,
                      edge_densities(problem.line, solution.pressure));
}

/// sigma_hat = C eps(u_h) + the composite stress of the difference.
inline std::vector<CompositeStress> admissible_stress(
    const Problem& problem, const Equilibrated& fields) {
  std::vector<CompositeStress> stress;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    stress.push_back(composite_stress(corners_of(problem.mesh, t),
                                      fields.difference.col(t),
                                      fields.loads.col(t)) +
                     fields.stress.col(t).replicate<1, 9>());
  return stress;
}

inline EquilibriumDefect defect_of(const Problem& problem,
                                   const Equilibrated& fields,
                                   const std::vector<CompositeStress>& stress) {
  return equilibrium_defect(problem.mesh, problem.edges, stress, fields.loads,
                            fields.boundary);
}

/// |sigma_hat - C eps(u_h)|^2, from the stress and not from the loads.
inline double elastic_square(const Problem& problem,
                             const Equilibrated& fields) {
  const std::vector<CompositeStress> stress =
      admissible_stress(problem, fields);
  double square = 0;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    square += energy(
        corners_of(problem.mesh, t), problem.hooke[t].inverse(),
        stress[t] - CompositeStress(fields.stress.col(t).replicate<1, 9>()));
  return square;
}

}  // namespace ffcontact::test
