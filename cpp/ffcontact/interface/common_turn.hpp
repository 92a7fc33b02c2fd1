// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Do contact directions of a line or surface and the opposite normals turn together? Sums
/// over pairs of neighbouring nodes, a = n_j - n_i of the directions and b = m_i - m_j of
/// the normals: (sum a . b) / (sum a . a) is 1 for a pin in its bore, 0 on a plane,
/// negative for two balls.
class CommonTurn {
 public:
  /// Directions that turn by less between two nodes are those of a plane.
  static constexpr double least = 0.01;

  /// @return whether the directions turn there
  template <class Vector>
  bool add(const Vector& a, const Vector& b) {
    if (a.norm() <= least) return false;
    own_ += a.squaredNorm();
    common_ += a.dot(b);
    return true;
  }
  /// Is the ratio between 1/2 and 2?
  bool fits() const { return common_ > 0.5 * own_ && common_ < 2 * own_; }

 private:
  double own_ = 0, common_ = 0;
};

}  // namespace ffcontact
