// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Values at the vertices of the linear traction with given moments on a facet of measure
/// A: d (d + 1) / A (b_i - sum of b_j / (d + 1)) [MPa], one column each.
template <int d>
MatrixOf<d> facet_density(const MatrixOf<d>& moments, double measure) {
  const VectorOf<d> part = 1.0 / (d + 1) * moments.rowwise().sum();
  return d * (d + 1) / measure * (moments.colwise() - part);
}

/// Moments of the linear traction with given values at the vertices:
/// A / (d (d + 1)) (F_i + sum of F_j).
template <int d>
MatrixOf<d> facet_moments_of(const MatrixOf<d>& density, double measure) {
  const VectorOf<d> sum = density.rowwise().sum();
  return measure / (d * (d + 1)) * (density.colwise() + sum);
}

}  // namespace ffcontact
