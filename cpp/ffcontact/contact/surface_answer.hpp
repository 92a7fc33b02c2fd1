// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/fixed_point/fixed_point.hpp"
#include "ffcontact/contact/newton/step_solver.hpp"

namespace ffcontact {

/// The law of a surface on its condensed relation: surface_newton from the chosen states,
/// where these lead nowhere from sticking nodes, then multiplier_method where the problem
/// is convex, friction_path, and spring_path where it has no start; or
/// surface_fixed_point. Singular where bodies slide.
/// @param stiffness  that contact was made with
/// @param held       of surface_trace [3 p]
FixedPointResult surface_answer(const CondensedContact& contact,
                                const CondensedStiffness& stiffness,
                                const NodalLaw& law, const Flags& held,
                                const ContactSettings& settings);

/// By surface_newton alone, to 1e-6: what a factor in single precision gives, before it is
/// corrected.
/// @param near    P and v to start from; nothing: the chosen states
/// @param solver  of its steps
ActiveSetResult rough_answer(const CondensedContact& contact,
                             const NodalLaw& law, const Flags& held,
                             const std::optional<ContactRows>& near,
                             const ContactSettings& settings,
                             StepSolver& solver);

}  // namespace ffcontact
