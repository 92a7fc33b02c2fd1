// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/linear_stress.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Values of a constant stress differ by less than this part of the largest.
constexpr double rounding_of_constants = 1e-14;

}  // namespace

template <int d>
LinearStresses<d> LinearStresses<d>::of_values(
    const Ref<const Values>& values) {
  constexpr int size = voigt_size<d>;
  LinearStresses result;
  result.mean = values.template topRows<size>();
  for (int k = 1; k <= d; ++k)
    result.mean += values.template middleRows<size>(size * k);
  result.mean /= d + 1;
  result.variation = values - result.mean.template replicate<d + 1, 1>();
  if (max_norm(result.variation) <= rounding_of_constants * max_norm(values))
    result.variation.resize(Values::RowsAtCompileTime, 0);
  return result;
}

template <int d>
typename LinearStresses<d>::Values LinearStresses<d>::values() const {
  Values values = mean.template replicate<d + 1, 1>();
  if (varies()) values += variation;
  return values;
}

template <int d>
VertexStress<d> LinearStresses<d>::at_vertices(int cell) const {
  VertexStress<d> values = mean.col(cell).template replicate<1, d + 1>();
  if (varies()) values.reshaped() += variation.col(cell);
  return values;
}

template <int d>
double LinearStresses<d>::bound() const {
  return max_norm(mean) + max_norm(variation);
}

template <int d>
LinearStresses<d> LinearStresses<d>::of_cells(
    const std::vector<int>& cells) const {
  LinearStresses result(CellStresses<d>(mean(Eigen::all, cells)));
  if (varies()) result.variation = variation(Eigen::all, cells);
  return result;
}

template <int d>
LinearStresses<d> operator+(LinearStresses<d> a, const LinearStresses<d>& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  a.mean += b.mean;
  if (!a.varies())
    a.variation = b.variation;
  else if (b.varies())
    a.variation += b.variation;
  return a;
}

template <int d>
SubcellStress<d> subcell_values(const VertexStress<d>& at_vertices) {
  SubcellStress<d> values;
  for (int k = 0; k <= d; ++k) {
    for (int j = 0; j < d; ++j)
      values.col((d + 1) * k + j) = at_vertices.col(vertex_of_facet<d>(k, j));
    values.col((d + 1) * k + d) = at_vertices.rowwise().mean();
  }
  return values;
}

template <int d>
FacetLoads<d> loads_of_stress(const CellCorners<d>& corners,
                              const VertexStress<d>& at_vertices) {
  return facet_loads_of(corners, subcell_values<d>(at_vertices));
}

template <int d>
BodyLoadsOfCells<d> difference_body_loads(const SimplexMesh<d>& mesh,
                                          BodyLoadsOfCells<d> loads,
                                          const LinearStresses<d>& stress) {
#pragma omp parallel for
  for (int t = 0; t < mesh.cell_count(); ++t)
    loads.col(t) -=
        balancing_body_loads<d>(
            loads_of_stress(corners_of(mesh, t), stress.at_vertices(t)))
            .reshaped();
  return loads;
}

template <int d>
void require_valid(const LinearStresses<d>& initial, int cells) {
  if (initial.empty()) return;
  require_size("initial stress", initial.mean.cols(), cells);
  for (int t = 0; t < cells; ++t)
    if (!initial.at_vertices(t).allFinite())
      refuse("the initial strain or stress on ", MeshWords<d>::cell, " ", t,
             " is not a finite number");
}

template struct LinearStresses<FFCONTACT_DIMENSION>;
template LinearStresses<FFCONTACT_DIMENSION> operator+(
    LinearStresses<FFCONTACT_DIMENSION>,
    const LinearStresses<FFCONTACT_DIMENSION>&);
template SubcellStress<FFCONTACT_DIMENSION> subcell_values<FFCONTACT_DIMENSION>(
    const VertexStress<FFCONTACT_DIMENSION>&);
template BodyLoadsOfCells<FFCONTACT_DIMENSION> difference_body_loads(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    BodyLoadsOfCells<FFCONTACT_DIMENSION>,
    const LinearStresses<FFCONTACT_DIMENSION>&);
template void require_valid(const LinearStresses<FFCONTACT_DIMENSION>&, int);
template FacetLoads<FFCONTACT_DIMENSION> loads_of_stress<FFCONTACT_DIMENSION>(
    const CellCorners<FFCONTACT_DIMENSION>&,
    const VertexStress<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
