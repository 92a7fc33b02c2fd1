// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ffcontact {

/// A place where the straight line through a point x along n meets the boundary of a
/// body.
struct Crossing {
  double distance;  ///< from x along n [mm]
  bool enters;      ///< does who goes along n enter the body there?
};

/// The two bodies that x and y = x + s n are on, along the line through both.
struct LineOfSight {
  std::vector<Crossing> own, other;
  bool is_one_body;  ///< both are the same
  double touching;   ///< distances below this are none [mm]

  /// Does x face y, where the outward normal at y opposes n?
  ///
  /// In front (s >= -touching) it does unless its own body lies between them. What lies
  /// behind is faced where bodies overlap: where y is inside the body of x, and so is all
  /// that is between them, or x inside that of y, likewise; both where it is one body,
  /// which counts as often as it covers a place. So a thin body faces nothing through
  /// itself.
  bool is_faced(double s) const;
};

}  // namespace ffcontact
