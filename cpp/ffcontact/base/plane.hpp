// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// a x b = |a| |b| sin(angle from a to b).
inline double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A linear function of s with the values `first` at 0 and `second` at 1, exactly also where
/// one is far smaller than the other: a large coefficient of friction multiplies it.
inline double between(double first, double second, double s) {
  return (1 - s) * first + s * second;
}
inline Vector2d between(const Vector2d& first, const Vector2d& second,
                        double s) {
  return first + s * (second - first);
}

/// The root of c0 + c1 s + c2 s^2 that stays finite as c2 -> 0, or infinity; nothing
/// where both are complex.
inline std::optional<double> finite_root(double c0, double c1, double c2) {
  const double root = c1 * c1 - 4 * c0 * c2;
  if (!(root >= 0)) return std::nullopt;
  return -2 * c0 / (c1 + (c1 < 0 ? -1 : 1) * std::sqrt(root));
}

}  // namespace ffcontact
