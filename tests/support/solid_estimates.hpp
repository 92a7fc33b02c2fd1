// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/relaxation/facet_relaxation.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "support/solid_problems.hpp"

/// From a solid in contact to the estimate of its error.
namespace ffcontact::test {

inline SolvedBody<3> solved_solid(const SolidProblem& problem,
                                  const ContactSolution<3>& solution) {
  return {HookeTensors<3>(problem.mesh.cell_count(),
                          isotropic<3>(13e3 * 0.2 / 0.72, 13e3 / 2.4)),
          solution.displacement,
          solution.force,
          problem.law,
          problem.neumann,
          BodyLoadsOfCells<3>::Zero(12, problem.mesh.cell_count()),
          solution.stiffness};
}

inline Estimate<3> estimate(const SolidProblem& problem,
                            const ContactSolution<3>& solution,
                            const RelaxationSettings& settings = {},
                            const RelaxFacets<3>& relax = relax_facets<3>) {
  return estimate_error(topology_of(problem.mesh), problem.surface,
                        problem.system(), solved_solid(problem, solution),
                        {settings, {}, relax});
}

inline Estimate<3> estimate(const SolidProblem& problem,
                            const RelaxationSettings& settings = {}) {
  return estimate(problem, problem.solve(), settings);
}

/// relax_facets where contact tractions stay as they are.
inline std::vector<double> relax_inside_alone(
    FacetSetting<3> setting, const RelaxationSettings& settings,
    FaceMoments& moments) {
  setting.contact.clear();
  setting.oscillation.clear();
  return relax_facets<3>(setting, settings, moments);
}

}  // namespace ffcontact::test
