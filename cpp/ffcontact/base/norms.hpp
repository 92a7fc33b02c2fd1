// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// max |x_i|
/// @param x  not empty
template <class Derived>
double max_norm(const Eigen::MatrixBase<Derived>& x) {
  return x.cwiseAbs().maxCoeff();
}

}  // namespace ffcontact
