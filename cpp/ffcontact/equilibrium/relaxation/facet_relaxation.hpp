// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ffcontact/equilibrium/cone/contact_relaxation.hpp"
#include "ffcontact/equilibrium/relaxation/facet_descent.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_settings.hpp"
#include "ffcontact/equilibrium/tractions/facet_setting.hpp"

namespace ffcontact {

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

/// @throws std::invalid_argument  if relax_facets takes more than that [bytes]
template <int d>
void require_room_for_relaxation(const FacetTopology<d>& topology,
                                 double available);

/// The same for all of a body. The result does not depend on the number of threads.
/// @param moments  in equilibrium, relaxed in place, those on contact facets in the cone
/// @return what e^2 fell by in every step [N mm, of plane bodies N/mm times mm]
/// @throws std::invalid_argument  if there is no room for it
template <int d>
std::vector<double> relax_facets(const FacetSetting<d>& setting,
                                 const RelaxationSettings& settings,
                                 FacetColumns<d>& moments);

/// relax_facets, or several processes that do the same.
template <int d>
using RelaxFacets = std::function<std::vector<double>(
    const FacetSetting<d>&, const RelaxationSettings&, FacetColumns<d>&)>;

}  // namespace ffcontact
