// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_settings.hpp"
#include "ffcontact/equilibrium/tractions/facet_setting.hpp"

namespace ffcontact {

/// The numbers that a relaxation in the plane and in space differ by.
template <int d>
struct RelaxationRule {
  /// Steps of the descent in one of the relaxation: two lower e of plane bodies as much as
  /// one of Gauss-Seidel over the stars with the best combination after each.
  static constexpr int descents = d == 2 ? 2 : 1;
  /// Steps between two passes over the contact ridges.
  static constexpr int steps_of_a_round = d == 2 ? 1 : 3;
  /// A pass that lowers e^2 by less than this part is the last one: where all of the
  /// surface slips there is little to be had. In the plane passes cost next to nothing, and
  /// go on.
  static constexpr double tightness_of_passes = d == 2 ? 0 : 2e-3;
  /// A star that lowers e^2 by less than this part of what it was at first may as well
  /// stay.
  static constexpr double least_part_of_a_star = d == 2 ? 0 : 1e-8;
  /// Steps where no number is given; further ones up to `most_steps` while `steps_judged`
  /// of them lower e by `worth_further_steps`.
  static constexpr int usual_steps = d == 2 ? 2 : 16,
                       most_steps = d == 2 ? 2 : 32, steps_judged = 4;
  static constexpr double worth_further_steps = 0.03;
};

/// Lowers e^2 by steps of a descent, after every round of them and the last one by a pass
/// over the contact as well, as long as these are worth their time; keeps equilibrium
/// exactly. What e^2 falls by in a step comes with it: the stopping test costs nothing. A
/// pass counts with the step before it. It ends where a step no longer changes a digit of
/// e.
/// @param report  is told e after every step (without Tresca's constant)
/// @return what e^2 fell by in every step [N mm, of plane bodies N/mm times mm]
template <int d>
std::vector<double> relax(FacetDescent<d>& descent,
                          ContactRelaxation<d>& contact,
                          const RelaxationSettings& settings,
                          const ProgressReport& report = {});

/// The same for all of a body. The result does not depend on the number of threads.
/// @param moments  in equilibrium, relaxed in place, those on contact facets in the cone
/// @return what e^2 fell by in every step [N mm, of plane bodies N/mm times mm]
template <int d>
std::vector<double> relax_facets(const FacetSetting<d>& setting,
                                 const RelaxationSettings& settings,
                                 FacetColumns<d>& moments);

/// relax_facets, or several processes that do the same.
template <int d>
using RelaxFacets = std::function<std::vector<double>(
    const FacetSetting<d>&, const RelaxationSettings&, FacetColumns<d>&)>;

}  // namespace ffcontact
