// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/equilibrium/stress/composite_element.hpp"

namespace ffcontact {

/// Values of a stress at the vertices of a cell, Voigt [MPa], one a column.
template <int d>
using VertexStress = Matrix<double, voigt_size<d>, d + 1>;

/// Stresses that are linear on each cell, Voigt [MPa]: C eps(u) of a linear u, which is
/// constant, and initial stresses, which vary.
template <int d>
struct LinearStresses {
  /// VertexStress, one cell a column, column-major
  using Values = Matrix<double, voigt_size<d>*(d + 1), Dynamic>;

  CellStresses<d> mean;
  /// what the values at the vertices have beyond the mean, which sums to 0; without
  /// columns: nothing
  Values variation;

  LinearStresses() : mean(voigt_size<d>, 0) {}
  explicit LinearStresses(CellStresses<d> constant)
      : mean(std::move(constant)) {}
  /// Where values vary by rounding alone the stresses are constant.
  static LinearStresses of_values(const Ref<const Values>& values);

  bool varies() const { return variation.cols() > 0; }
  bool empty() const { return mean.cols() == 0; }
  Values values() const;
  VertexStress<d> at_vertices(int cell) const;
  /// No value is larger.
  double bound() const;
  LinearStresses of_cells(const std::vector<int>& cells) const;
};

/// Sums, where an empty stress is zero.
template <int d>
LinearStresses<d> operator+(LinearStresses<d> a, const LinearStresses<d>& b);

template <int d>
LinearStresses<d> operator*(double factor, LinearStresses<d> stress) {
  stress.mean *= factor;
  stress.variation *= factor;
  return stress;
}

/// A linear stress by its values at the vertices of a cell: at the corners of the subcells.
template <int d>
SubcellStress<d> subcell_values(const VertexStress<d>& at_vertices);

/// Its loads on the facets.
template <int d>
FacetLoads<d> loads_of_stress(const CellCorners<d>& corners,
                              const VertexStress<d>& at_vertices);

/// Body loads of sigma_hat - sigma from those of sigma_hat; the same where sigma does not
/// vary in the cells.
template <int d>
BodyLoadsOfCells<d> difference_body_loads(const SimplexMesh<d>& mesh,
                                          BodyLoadsOfCells<d> loads,
                                          const LinearStresses<d>& stress);

/// @throws std::invalid_argument  if there is not one for each cell, or one is not finite
template <int d>
void require_valid(const LinearStresses<d>& initial, int cells);

}  // namespace ffcontact
