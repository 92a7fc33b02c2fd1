// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/equilibrium/tractions/equilibrated_moments.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "support/problems.hpp"

/// From a problem to its admissible fields.
namespace ffcontact::test {

/// The problems are small: two threads would only wait for each other. Tests of threads
/// set their own number.
inline const bool one_thread = (omp_set_num_threads(1), true);

/// int f phi_i of a body force that is constant on each triangle.
inline BodyLoadsOfCells<2> body_loads(const Problem& problem) {
  BodyLoadsOfCells<2> loads(6, problem.mesh.cells.cols());
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    loads.col(t) =
        (signed_area(problem.mesh, t) / 3 * problem.body_force.col(t))
            .replicate<3, 1>();
  return loads;
}

inline SolvedBody<2> solved_body(const Problem& problem,
                                 const ContactSolution<2>& solution) {
  return {problem.hooke,     solution.displacement, solution.pressure,
          problem.law,       problem.neumann,       body_loads(problem),
          solution.stiffness};
}

inline EstimateSettings<2> sweeps(int count,
                                  Tractions tractions = Tractions::free) {
  EstimateSettings<2> settings;
  settings.relaxation.steps = count;
  settings.tractions = tractions;
  return settings;
}

inline Estimate<2> estimated(const Problem& problem,
                             const ContactSolution<2>& solution,
                             const EstimateSettings<2>& settings = {}) {
  return estimate_error(topology_of(problem.mesh), problem.line,
                        problem.system(), solved_body(problem, solution),
                        settings);
}

/// What star relaxation starts from: edge tractions in equilibrium with the contact
/// tractions of the solver.
struct Equilibrated {
  Topology<2> topology;
  LinearStresses<2> stress;  ///< C eps(u_h)
  BoundaryTractions boundary;
  EdgeMoments moments;
  Hooke hooke;
  BodyLoadsOfCells<2> loads;

  LoadedFacets<2> difference() const {
    return {topology, hooke, boundary, loads, stress};
  }
  SubcellStress<2> sigma(int t) const {
    return subcell_values<2>(stress.at_vertices(t));
  }
};

inline Equilibrated equilibrated(const Problem& problem,
                                 const VectorXd& displacement,
                                 const ContactDensities& densities) {
  Equilibrated result;
  result.topology = topology_of(problem.mesh);
  result.stress =
      LinearStresses<2>(stresses(problem.mesh, problem.hooke, displacement));
  result.boundary = boundary_tractions(
      problem.mesh, problem.edges, prescribed_dofs(problem.A), problem.neumann,
      problem.line, densities);
  result.loads = body_loads(problem);
  result.hooke = problem.hooke;
  const CellStresses<2>& stress = result.stress.mean;
  require_balanced(problem.mesh, nodal_residual(result.topology, stress,
                                                result.loads, result.boundary));
  result.moments = equilibrated_moments(result.topology, stress, result.loads,
                                        result.boundary);
  return result;
}

inline Equilibrated equilibrated(const Problem& problem,
                                 const ContactSolution<2>& solution) {
  return equilibrated(problem, solution.displacement,
                      edge_densities(problem.line, solution.pressure));
}

/// sigma_hat = C eps(u_h) + the composite stress of the difference.
inline std::vector<SubcellStress<2>> admissible_stress(
    const Problem& problem, const Equilibrated& fields) {
  std::vector<SubcellStress<2>> stress;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    stress.push_back(
        difference_stress<2>(fields.difference(), fields.moments, t) +
        fields.sigma(t));
  return stress;
}

inline EquilibriumDefect defect_of(
    const Problem& problem, const Equilibrated& fields,
    const std::vector<SubcellStress<2>>& stress) {
  const Mesh& mesh = problem.mesh;
  EquilibriumDefect worst;
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const EquilibriumDefect own =
        cell_defect<2>(corners_of(mesh, t), stress[t],
                       loads_of<2>(mesh, problem.edges, fields.moments, t),
                       fields.loads.col(t).reshaped(2, 3));
    worst.divergence = std::max(worst.divergence, own.divergence);
    worst.jump = std::max(worst.jump, own.jump);
  }
  worst.boundary =
      boundary_defect<2>(mesh, problem.edges, fields.boundary, fields.moments);
  const double scale = largest_traction<2>(mesh, problem.edges, fields.moments);
  return worst.relative_to(scale > 0 ? scale : 1);
}

/// |sigma_hat - C eps(u_h)|^2, from the stress and not from the loads.
inline double elastic_square(const Problem& problem,
                             const Equilibrated& fields) {
  const std::vector<SubcellStress<2>> stress =
      admissible_stress(problem, fields);
  double square = 0;
  for (int t = 0; t < problem.mesh.cell_count(); ++t)
    square += energy(corners_of(problem.mesh, t), problem.hooke[t].inverse(),
                     stress[t] - fields.sigma(t));
  return square;
}

}  // namespace ffcontact::test
