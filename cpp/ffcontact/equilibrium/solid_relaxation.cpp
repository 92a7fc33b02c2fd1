// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/solid_relaxation.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/relaxation_progress.hpp"

namespace ffcontact {

std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments) {
  if (settings.steps == 0) return {};
  FaceDescent descent(setting, moments);
  RelaxationProgress progress(descent.first_square(),
                              descent.first_contact_part());
  std::vector<double> falls;
  for (bool goes_on = true; goes_on;) {
    falls.push_back(descent.step());
    const int steps = count_of(falls);
    if (steps % steps_of_a_round == 0) falls.back() += descent.contact_pass();
    goes_on = progress.goes_on(falls.back(), settings.tightness) &&
              steps < settings.steps;
  }
  if (falls.size() % steps_of_a_round != 0)
    falls.back() += descent.contact_pass();
  moments += descent.correction();
  return falls;
}

}  // namespace ffcontact
