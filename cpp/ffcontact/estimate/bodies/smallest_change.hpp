// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/linear/minimum/quadratic_minimum.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// A free component moves no node out of the foundation whose normal has less of it than this:
/// it would be rounding of the normal.
constexpr double least_component = 1e-9;
/// No vertex moves farther than this, against the largest displacement or gap.
constexpr double farthest = 1e3;

/// The smallest change x of free components with away x >= deep: nothing if there is none, or
/// only one above `largest` [mm].
/// @param away  what x moves each node along its normal by [nodes x components]
inline std::optional<VectorXd> smallest_change(const MatrixXd& away,
                                               const VectorXd& deep,
                                               double largest) {
  const Index size = away.cols();
  if (deep.maxCoeff() <= 0) return VectorXd(VectorXd::Zero(size));
  const auto change = quadratic_minimum(MatrixXd::Identity(size, size),
                                        VectorXd::Zero(size), away, deep);
  if (!change || max_norm(*change) > largest) return std::nullopt;
  return *change;
}

}  // namespace ffcontact
