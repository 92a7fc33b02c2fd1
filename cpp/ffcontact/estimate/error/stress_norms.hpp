// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"
#include "ffcontact/equilibrium/tractions/facet_loads.hpp"

namespace ffcontact {

/// sigma_hat by its moments on the facets, and sigma, which it is compared with.
template <int d>
struct StressPair {
  const LoadedFacets<d>& difference;
  const FacetColumns<d>& moments;
  const BodyLoadsOfCells<d>& body_loads;  ///< of sigma_hat
};

/// On one cell: |tau|^2 = int C^-1 tau : tau of sigma_hat - sigma and sigma_hat + sigma, and
/// sigma_hat.
template <int d>
struct CellNorms {
  double difference, sum;
  SubcellStress<d> stress;
};
template <int d>
using NormsOfCell = CellNorms<d> (*)(const StressPair<d>& pair, int cell);

/// Of composite stresses. sigma_hat is that of its own loads: sigma may be far larger.
template <int d>
CellNorms<d> composite_norms(const StressPair<d>& pair, int cell);

/// What (2.11) and (2.12) take of sigma_hat, and how far it is from equilibrium.
template <int d>
struct StressNorms {
  VectorXd difference;       ///< |sigma_hat - sigma|^2 per cell [N mm]
  double sum;                ///< |sigma_hat + sigma|^2 in all
  EquilibriumDefect defect;  ///< [MPa]
  double largest;            ///< component of sigma_hat [MPa]
};

/// @param stress  null, or takes sigma_hat at the corners of the subcells [MPa]
template <int d>
StressNorms<d> stress_norms(const StressPair<d>& pair,
                            NormsOfCell<d> norms_of = composite_norms<d>,
                            std::vector<SubcellStress<d>>* stress = nullptr);

}  // namespace ffcontact
