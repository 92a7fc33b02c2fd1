// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/tree_sweep.hpp"

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/equilibrium/tractions/unrooted_part.hpp"

namespace ffcontact {

namespace {

/// What one cell lacks about its point.
template <int d>
Wrench<d> lacking(const RootedCells<d>& rooted,
                  const BodyLoadsOfCells<d>& body_loads,
                  const FacetColumns<d>& moments, int cell) {
  const WrenchPoint<d> about = rooted.point(cell);
  const CellCorners<d> corners = rooted.topology.corners(cell);
  const CellBodyLoads<d> in_cell = loads_in_cell<d>(body_loads, cell);
  const FacetLoads<d> loads = loads_of(rooted.topology, moments, cell);
  Wrench<d> sum = Wrench<d>::Zero();
  for (int k = 0; k <= d; ++k) {
    about.add(corners.col(k), in_cell.col(k), sum);
    for (int j = 0; j < d; ++j)
      about.add(corners.col(vertex_of_facet<d>(k, j)), loads.col(d * k + j),
                sum);
  }
  return sum;
}

template <int d>
std::vector<int> supported_facets(const Facets<d>& facets,
                                  const FacetTractions<d>& boundary) {
  std::vector<int> roots;
  for (int f = 0; f < facets.count(); ++f)
    if (facets.on_boundary(f) && !boundary.known.col(f).any())
      roots.push_back(f);
  return roots;
}

/// Every wrench and those from below it, each about its cell's point.
template <int d>
void add_up(const RootedCells<d>& rooted, CellWrenches<d>& wrenches) {
  const std::vector<int>& cells = rooted.trees.cell;
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) {
    const int above = rooted.above(*cell);
    if (above >= 0)
      wrenches.col(above) += moved<d>(wrenches.col(*cell), rooted.point(*cell),
                                      rooted.point(above));
  }
}

}  // namespace

template <int d>
void sweep_to_roots(const FacetTopology<d>& topology,
                    const BodyLoadsOfCells<d>& body_loads,
                    const FacetTractions<d>& boundary,
                    const std::vector<FreeSpring<d>>& springs,
                    FacetColumns<d>& moments) {
  const CellTrees trees =
      cell_trees(topology.facets, supported_facets(topology.facets, boundary));
  const RootedCells<d> rooted{topology, trees};
  const int cells = topology.mesh.cell_count();
  CellWrenches<d> wrenches(CompositeElement<d>::wrench, cells);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t)
    wrenches.col(t) = lacking(rooted, body_loads, moments, t);

  const Answers<d> answers(boundary, springs);
  for (std::size_t k = 1; k < trees.without_root.size(); ++k) {
    const UnrootedPart<d> part(rooted, &trees.cell[trees.without_root[k - 1]],
                               &trees.cell[0] + trees.without_root[k]);
    part.let_answer(answers, wrenches, moments);
    for (int t : part.cells())
      wrenches.col(t) = lacking(rooted, body_loads, moments, t);
    part.keep(wrenches);
  }

  add_up(rooted, wrenches);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    const int facet = trees.facet[t];
    if (facet < 0) continue;
    const double eta = topology.facets.cells(0, facet) == t ? 1 : -1;
    moments.col(facet) -= eta *
                          wrench_moments<d>(topology.facet_corners(facet)) *
                          wrenches.col(t);
  }
}

template void sweep_to_roots(
    const FacetTopology<FFCONTACT_DIMENSION>&,
    const BodyLoadsOfCells<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&,
    const std::vector<FreeSpring<FFCONTACT_DIMENSION>>&,
    FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
