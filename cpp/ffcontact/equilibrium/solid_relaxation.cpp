// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/solid_relaxation.hpp"

#include "ffcontact/equilibrium/relaxation_progress.hpp"

namespace ffcontact {

std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments) {
  if (settings.steps == 0) return {};
  FaceDescent descent(setting, moments);
  RelaxationProgress progress(descent.first_square(), 0);
  std::vector<double> falls;
  for (int step = 0; step < settings.steps; ++step) {
    falls.push_back(descent.step());
    if (!progress.goes_on(falls.back(), settings.tightness)) break;
  }
  moments += descent.correction();
  return falls;
}

}  // namespace ffcontact
