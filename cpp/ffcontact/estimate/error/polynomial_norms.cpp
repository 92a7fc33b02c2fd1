// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/polynomial_norms.hpp"

#include "ffcontact/equilibrium/stress/polynomial_stress.hpp"

namespace ffcontact {

CellNorms<2> polynomial_norms(const StressPair<2>& pair, int triangle) {
  const LoadedFacets<2>& difference = pair.difference;
  const VertexStress<2> sigma = difference.stress.at_vertices(triangle);
  const PolynomialStress tau = polynomial_stress(
      difference.topology.corners(triangle), difference.hooke[triangle],
      difference_loads(difference, pair.moments, triangle),
      loads_in_cell<2>(difference.body_loads, triangle));
  return {energy(tau, VertexStress<2>::Zero()), energy(tau, 2 * sigma),
          corner_values(tau) + subcell_values<2>(sigma)};
}

}  // namespace ffcontact
