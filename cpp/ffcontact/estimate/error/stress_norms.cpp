// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/stress_norms.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "ffcontact/base/parted_sum.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

template <int d>
FacetLoads<d> loads_of(const StressPair<d>& pair, int cell) {
  return loads_of(pair.difference.topology, pair.moments, cell);
}

}  // namespace

template <int d>
CellNorms<d> composite_norms(const StressPair<d>& pair, int cell) {
  const LoadedFacets<d>& difference = pair.difference;
  const CellCorners<d> corners = difference.topology.corners(cell);
  const VoigtMatrix<d> compliance = difference.hooke[cell].inverse();
  const SubcellStress<d> sigma = subcell_values<d>(
                             difference.stress.at_vertices(cell)),
                         tau =
                             difference_stress(difference, pair.moments, cell);
  return {energy(corners, compliance, tau),
          energy(corners, compliance, tau + 2 * sigma),
          composite_stress<d>(corners, loads_of(pair, cell),
                              loads_in_cell<d>(pair.body_loads, cell))};
}

template <int d>
StressNorms<d> stress_norms(const StressPair<d>& pair, NormsOfCell<d> norms_of,
                            std::vector<SubcellStress<d>>* stress) {
  const int cells = pair.difference.topology.mesh.cell_count();
  StressNorms<d> norms{VectorXd(cells), 0, {}, 0};
  if (stress) stress->resize(cells);
  VectorXd sums(cells);
  double divergence = 0, jump = 0, largest = 0;
#pragma omp parallel for reduction(max : divergence, jump, largest)
  for (int t = 0; t < cells; ++t) {
    const CellNorms<d> own = norms_of(pair, t);
    norms.difference[t] = own.difference;
    sums[t] = own.sum;
    if (stress) (*stress)[t] = own.stress;
    const EquilibriumDefect defect =
        cell_defect<d>(pair.difference.topology.corners(t), own.stress,
                       loads_of(pair, t), loads_in_cell<d>(pair.body_loads, t));
    divergence = std::max(divergence, defect.divergence);
    jump = std::max(jump, defect.jump);
    largest = std::max(largest, max_norm(own.stress));
  }
  norms.sum = parted_sum(cells, [&](int t) { return sums[t]; });
  const auto& [mesh, facets, ridges] = pair.difference.topology;
  norms.defect = {
      divergence, jump,
      boundary_defect(mesh, facets, pair.difference.boundary, pair.moments)};
  norms.largest = largest;
  return norms;
}

template CellNorms<FFCONTACT_DIMENSION> composite_norms<FFCONTACT_DIMENSION>(
    const StressPair<FFCONTACT_DIMENSION>&, int);
template StressNorms<FFCONTACT_DIMENSION> stress_norms<FFCONTACT_DIMENSION>(
    const StressPair<FFCONTACT_DIMENSION>&, NormsOfCell<FFCONTACT_DIMENSION>,
    std::vector<SubcellStress<FFCONTACT_DIMENSION>>*);

}  // namespace ffcontact
