// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/composite_stress.hpp"

namespace ffcontact {

/// Stresses that are linear on each triangle, Voigt [MPa]: C eps(u) of a linear u, which
/// is constant, and initial stresses, which vary.
struct LinearStresses {
  Matrix3Xd mean;  ///< [3 x triangles]
  /// what the values at the three vertices have beyond the mean, which sums to 0; without
  /// columns: nothing
  Matrix<double, 9, Dynamic> variation;

  LinearStresses() : mean(3, 0) {}
  // NOLINTNEXTLINE(google-explicit-constructor): constant stresses are linear
  LinearStresses(Matrix3Xd constant) : mean(std::move(constant)) {}
  /// @param values  at the vertices, one triangle a column [9 x triangles]; where they
  ///                vary by rounding alone the stresses are constant
  static LinearStresses of_values(
      const Ref<const Matrix<double, 9, Dynamic>>& values);

  bool varies() const { return variation.cols() > 0; }
  bool empty() const { return mean.cols() == 0; }
  /// Values at the vertices of a triangle, one a column.
  Matrix3d at_vertices(int triangle) const;
};

/// Sums, where an empty stress is zero.
LinearStresses operator+(LinearStresses a, const LinearStresses& b);

/// A linear stress by its values at the vertices of a triangle: at the corners of the
/// subtriangles.
CompositeStress composite_of(const Matrix3d& at_vertices);

/// Its edge loads.
EdgeLoads edge_loads(const TriangleCorners& corners,
                     const Matrix3d& at_vertices);

/// int f phi_i of f = -div sigma [N/mm].
BodyLoads balancing_loads(const TriangleCorners& corners,
                          const Matrix3d& at_vertices);

}  // namespace ffcontact
