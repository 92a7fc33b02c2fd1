// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"

namespace ffcontact {

/// The law of a surface where Newton finds no solution by itself: along FrictionCurve from
/// the solution without friction, s = 0, to the one of the law, s = 1. Steps are shortened
/// where they miss the curve, and short ones turn at its kinks; from the step that passes
/// s = 1 surface_newton ends. With much friction the curve turns back and forth in s, where
/// methods that raise s step by step come to nothing.
///
/// Its first point is to exist: a body that friction alone holds has none (spring_path).
/// @param held  of surface_trace [3 p]
/// @return      converged, or not with the best of what Newton left
ActiveSetResult friction_path(const CondensedContact& contact,
                              const NodalLaw& law, const Flags& held,
                              const NewtonSettings& settings);

}  // namespace ffcontact
