// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/face_descent.hpp"

namespace ffcontact {

struct SolidRelaxationSettings {
  int steps = 16;  ///< at most; fewer where one no longer lowers e
  /// stop when the last step lowered e by less than this fraction; 0: do all steps
  double tightness = 0;
};

/// Lowers e^2 = |sigma_hat - sigma|^2 by steps of FaceDescent, and keeps equilibrium
/// exactly. What e^2 falls by in a step comes with it: the stopping test costs nothing.
/// @param moments  in equilibrium, relaxed in place
/// @return what e^2 fell by in every step [N mm]
std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments);

}  // namespace ffcontact
