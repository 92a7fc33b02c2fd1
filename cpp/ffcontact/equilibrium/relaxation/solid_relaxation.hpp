// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/relaxation/face_setting.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"

namespace ffcontact {

struct SolidRelaxationSettings {
  /// at most; fewer where one no longer lowers e. Without a number 16, and, as nearly
  /// incompressible bodies need, further ones while four of them lower e by 3 %, up to 32
  std::optional<int> steps{};
  /// stop when the last step lowered e by less than this fraction; 0: do all steps
  double tightness = 0;
};

/// Steps between two passes over the contact edges.
constexpr int steps_of_a_round = 3;

/// Lowers e^2 by steps of a descent, after every round of them and the last one by a pass
/// over the contact as well, as long as these are worth their time; keeps equilibrium
/// exactly. What e^2 falls by in a step comes with it: the stopping test costs nothing. A
/// pass counts with the step before it.
/// @return what e^2 fell by in every step [N mm]
std::vector<double> relax(FacetDescent<3>& descent, ContactRelaxation& contact,
                          const SolidRelaxationSettings& settings);

/// The same for all of a solid.
/// @param moments  in equilibrium, relaxed in place, those on contact faces in the cone
/// @return what e^2 fell by in every step [N mm]
std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments);

/// relax_faces, or several processes that do the same.
using RelaxFaces = std::function<std::vector<double>(
    const FaceSetting&, const SolidRelaxationSettings&, FaceMoments&)>;

}  // namespace ffcontact
