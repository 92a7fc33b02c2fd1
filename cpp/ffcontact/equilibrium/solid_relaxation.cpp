// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/solid_relaxation.hpp"

#include "ffcontact/base/packed.hpp"
#include "ffcontact/equilibrium/relaxation_progress.hpp"

namespace ffcontact {

namespace {

/// A pass that lowers e by less than this part is the last one: where all of the surface
/// slips there is little to be had.
constexpr double tightness_of_passes = 1e-3;

}  // namespace

std::vector<double> relax_faces(const FaceSetting& setting,
                                const SolidRelaxationSettings& settings,
                                FaceMoments& moments) {
  if (settings.steps == 0) return {};
  FaceDescent descent(setting, moments);
  RelaxationProgress progress(descent.first_square(),
                              descent.first_contact_part());
  std::vector<double> falls;
  bool goes_on = true, passes = !setting.contact.empty();
  while (goes_on) {
    falls.push_back(descent.step());
    const int steps = count_of(falls);
    goes_on = progress.goes_on(falls.back(), settings.tightness) &&
              steps < settings.steps;
    if (!passes || (goes_on && steps % steps_of_a_round != 0)) continue;
    const double of_pass = descent.contact_pass();
    falls.back() += of_pass;
    passes = progress.goes_on(of_pass, tightness_of_passes);
  }
  moments += descent.correction();
  return falls;
}

}  // namespace ffcontact
