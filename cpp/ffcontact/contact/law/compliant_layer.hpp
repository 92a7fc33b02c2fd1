// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"

namespace ffcontact {

/// An elastic layer in the interface, as of asperities or a coating, in series with contact:
/// under tractions (r_n, r_t) it gives way by (c_n r_n, c_t r_t), and what is left,
///     v = (u_n - gap + c_n r_n, u_t - previous + c_t r_t),
/// obeys the law of contact.
struct CompliantLayer {
  double normal = 0, tangential = 0;  ///< c_n, c_t >= 0 [mm/MPa]

  bool given() const { return normal > 0 || tangential > 0; }
  /// Of a component, the normal one is 0.
  double of(Index component) const {
    return component == 0 ? normal : tangential;
  }
  /// (c_n r_n, c_t r_t) of tractions, one column each [mm].
  template <class Tractions>
  Tractions given_way(const Tractions& traction) const {
    Tractions moved = tangential * traction;
    moved.row(0) = normal * traction.row(0);
    return moved;
  }
};

/// Gaps or displacements of the load step before, 0 if there are none, less what a layer gives
/// way by.
template <class Values>
Values beyond(const Values& given, const Values& given_way) {
  return given.size() > 0 ? Values(given - given_way) : Values(-given_way);
}

/// @throws std::invalid_argument  if a compliance is negative or not finite
void require_valid(const CompliantLayer& layer);

/// c / A of all rows of nodes [mm/N, of plane bodies mm^2/N], 0 on held ones.
/// @param area  of the line or surface that belongs to each node [p]
VectorXd nodal_compliance(const CompliantLayer& layer, const VectorXd& area,
                          int dimension, const Flags& held);

}  // namespace ffcontact
