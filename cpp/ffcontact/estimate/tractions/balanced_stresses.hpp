// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/estimate/tractions/rebalancing.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// Solves for the balance of stresses and tractions: one, and one or two for its rounding.
constexpr int most_refinements = 3;

/// What is missing of the largest moment in balanced stresses: a traction on the short
/// edge of a thin triangle that balances it is larger by the ratio of its sides.
constexpr double balanced = 1e-13;

template <int d>
struct BalancedStresses {
  CellStresses<d> stress;
  bool to_rounding;  ///< is no more missing than `balanced`?
};

/// Stresses in equilibrium with loads and contact tractions: the given ones, and those of
/// the small displacement that makes up for what they lack; its own rounding once more.
/// @param wanted       what may be missing, of the largest moment: `balanced` or more
/// @param residual     what the stresses lack beside all loads and tractions
/// @param rebalancing  makes a Rebalancing; not called where nothing is missing
/// @param springs      answer that displacement, too
/// @param keep         keep(change of the moments of their tractions)
template <int d, class MakeRebalancing, class Keep>
BalancedStresses<d> balanced_stresses(
    double wanted, const Topology<d>& topology, const HookeTensors<d>& hooke,
    NodalResidual<d> residual, CellStresses<d> stress,
    const MakeRebalancing& rebalancing, const BoundarySprings<d>& springs,
    const Keep& keep) {
  const auto missing = [&] { return max_norm(residual.missing); };
  const auto is_balanced = [&](double part) {
    return missing() <= part * residual.scale;
  };
  if (is_balanced(wanted)) return {std::move(stress), is_balanced(balanced)};
  const Rebalancing solver = rebalancing();
  for (int step = 0; step < most_refinements && !is_balanced(wanted); ++step) {
    const double before = missing();
    const VectorXd u = solver.displacement(residual.missing.reshaped());
    const CellStresses<d> added = stresses(topology.mesh, hooke, u);
    const FacetColumns<d> answers =
        spring_moment_changes<d>(topology.mesh, springs, u);
    residual = with_forces(less_stress(topology, std::move(residual), added),
                           boundary_forces<d>(topology.mesh, answers));
    if (step > 0 && missing() >= before) break;
    stress += added;
    if (!springs.empty()) keep(answers);
  }
  return {std::move(stress), is_balanced(balanced)};
}

}  // namespace ffcontact
