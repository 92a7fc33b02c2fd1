// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/mesh/cell_trees.hpp"

namespace ffcontact {

/// A point about which wrenches are taken, and the length that moments are divided by.
template <int d>
struct WrenchPoint {
  VectorOf<d> place;
  double size;

  MomentMatrix<d> arm(const VectorOf<d>& x) const {
    return moment_matrix<d>(VectorOf<d>((x - place) / size));
  }
  void add(const VectorOf<d>& x, const VectorOf<d>& force,
           Wrench<d>& sum) const {
    sum.template head<d>() += force;
    sum.template tail<CompositeElement<d>::turns>() += arm(x) * force;
  }
  /// a + c x (x - x_0) / L of (a, c)
  VectorOf<d> rigid(const VectorOf<d>& x, const Wrench<d>& motion) const {
    return motion.template head<d>() +
           arm(x).transpose() *
               motion.template tail<CompositeElement<d>::turns>();
  }
};

/// One column a cell.
template <int d>
using CellWrenches = Matrix<double, CompositeElement<d>::wrench, Dynamic>;

/// The same wrench about another point.
template <int d>
Wrench<d> moved(const Wrench<d>& w, const WrenchPoint<d>& from,
                const WrenchPoint<d>& to) {
  constexpr int turns = CompositeElement<d>::turns;
  const VectorOf<d> force = w.template head<d>();
  Wrench<d> result;
  result << force, from.size / to.size * w.template tail<turns>() +
                       to.arm(from.place) * force;
  return result;
}

/// A mesh with the trees of its cells.
template <int d>
struct RootedCells {
  const FacetTopology<d>& topology;
  const CellTrees& trees;

  /// Of the facet towards the root, or of a first cell.
  WrenchPoint<d> point(int cell) const {
    const int towards = trees.facet[cell];
    const int facet = towards >= 0 ? towards : topology.facets.of_cell(0, cell);
    const MatrixOf<d> corners = topology.facet_corners(facet);
    return {corners.rowwise().mean(), size_of_facet<d>(corners)};
  }
  /// Beyond the facet towards the root; -1: none.
  int above(int cell) const {
    const int facet = trees.facet[cell];
    if (facet < 0) return -1;
    const Vector2i sides = topology.facets.cells.col(facet);
    return sides[0] == cell ? sides[1] : sides[0];
  }
};

}  // namespace ffcontact
