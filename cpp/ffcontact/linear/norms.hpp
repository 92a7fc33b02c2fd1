// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// max |x_i|, 0 of nothing.
template <class Derived>
double max_norm(const Eigen::MatrixBase<Derived>& x) {
  return x.size() > 0 ? x.cwiseAbs().maxCoeff() : typename Derived::Scalar(0);
}

/// value / scale, 0 where there is no scale.
inline double relative(double value, double scale) {
  return scale > 0 ? value / scale : 0;
}

/// Lengths of the sides of the box around points, one column each.
template <class Derived>
Matrix<typename Derived::Scalar, Derived::RowsAtCompileTime, 1> box_sides(
    const Eigen::MatrixBase<Derived>& points) {
  return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
}

}  // namespace ffcontact
