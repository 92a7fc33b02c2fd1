// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/composite_stress.hpp"
#include "ffcontact/equilibrium/tractions/difference_loads.hpp"

namespace ffcontact {

/// sigma_hat inside the triangles, and what (2.11) and (2.12) take of it, with
/// |tau|^2 = int C^-1 tau : tau.
struct StressNorms {
  VectorXd difference;  ///< |sigma_hat - sigma|^2 per triangle [N/mm times mm]
  double sum;           ///< |sigma_hat + sigma|^2 in all
  /// sigma_hat at the corners of the subtriangles [MPa]
  std::vector<CompositeStress> stress;
};

/// @param stress      sigma [MPa]
/// @param difference  edge loads of sigma_hat - sigma
/// @param body_loads  int f phi_i per triangle, of sigma_hat - sigma
StressNorms composite_norms(const Mesh& mesh, const Hooke& hooke,
                            const LinearStresses& stress,
                            const EdgeLoadsOfAll& difference,
                            const BodyLoadsOfAll& body_loads);

/// The same for the polynomial construction.
StressNorms polynomial_norms(const Mesh& mesh, const Hooke& hooke,
                             const LinearStresses& stress,
                             const EdgeLoadsOfAll& difference,
                             const BodyLoadsOfAll& body_loads);

}  // namespace ffcontact
