// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "ffcontact/equilibrium/stress/composite_element.hpp"

namespace ffcontact {

/// Which components of the traction on each facet are given [d x facets].
template <int d>
using KnownTractions = Eigen::Array<bool, d, Dynamic>;
using KnownComponents = KnownTractions<3>;
template <int d>
using KnownDirections = std::map<int, VectorOf<d>>;

/// What the boundary of an admissible stress must carry, per facet and Cartesian component.
template <int d>
struct FacetTractions {
  KnownTractions<d> known;  ///< false inside the body
  /// int F phi at the vertices of the facet of the known components, F = sigma n with the
  /// facet's normal (outward on the boundary), 0 elsewhere [N]
  FacetColumns<d> moments;
  /// of boundary facets along which one direction, not an axis, is known alone: that one
  KnownDirections<d> known_direction{};
};

/// Known moments to the last digit, where there are others but for rounding.
template <int d>
void put_known(const FacetTractions<d>& boundary, FacetColumns<d>& moments) {
  for (Index f = 0; f < moments.cols(); ++f)
    for (int row = 0; row < moments.rows(); ++row)
      if (boundary.known(row % d, f))
        moments(row, f) = boundary.moments(row, f);
}

}  // namespace ffcontact
