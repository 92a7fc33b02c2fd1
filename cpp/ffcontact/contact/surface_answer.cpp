// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_answer.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/continuation/friction_path.hpp"
#include "ffcontact/contact/continuation/spring_path.hpp"
#include "ffcontact/contact/fixed_point/surface_fixed_point.hpp"
#include "ffcontact/contact/newton/multiplier_method.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"

namespace ffcontact {

namespace {

/// Violation of an answer by a factor in single precision before it is corrected.
constexpr double tolerance_to_be_corrected = 1e-6;
/// Newton is given this many linear systems before other methods go on.
constexpr int most_newton_systems = 100;

int systems_left(const NewtonSettings& limits, const ActiveSetResult& answer) {
  const bool found = answer.status == ContactStatus::converged;
  return found ? 0 : limits.max_iterations - answer.iterations;
}

/// Newton from the given states, and where these lead nowhere from sticking nodes.
ActiveSetResult newton_answer(const CondensedContact& contact,
                              const NodalLaw& law, const Flags& held,
                              const ContactStates& start,
                              const NewtonSettings& limits) {
  const ContactStates stick = all_stick(law.node_count());
  const auto first_of = [&limits](int left) {
    return limits.with_at_most(std::min(most_newton_systems, left));
  };
  ActiveSetResult best = surface_newton(contact, law, held, start,
                                        first_of(limits.max_iterations));
  const int left = limits.max_iterations - best.iterations;
  if (best.status == ContactStatus::converged || left <= 0 || start == stick)
    return best;
  best.add(surface_newton(contact, law, held, stick, first_of(left)));
  return best;
}

}  // namespace

ActiveSetResult rough_answer(const CondensedContact& contact,
                             const NodalLaw& law, const Flags& held,
                             const std::optional<ContactRows>& near,
                             const ContactSettings& settings,
                             StepSolver& solver) {
  const double enough = std::max(settings.tolerance, tolerance_to_be_corrected);
  const NewtonSettings limits{
      std::min(most_newton_systems, settings.max_iterations), enough,
      settings.report, enough};
  return near ? surface_newton(contact, law, held, *near, solver, limits)
              : surface_newton(contact, law, held,
                               settings.first_states(law.node_count()), solver,
                               limits);
}

FixedPointResult surface_answer(const CondensedContact& contact,
                                const CondensedStiffness& stiffness,
                                const NodalLaw& law, const Flags& held,
                                const ContactSettings& settings) {
  const ContactStates start = settings.first_states(law.node_count());
  const NewtonSettings limits{settings.max_iterations, settings.tolerance,
                              settings.report};
  if (settings.solver == ContactSolver::fixed_point && !law.is_bonded())
    return surface_fixed_point(contact, law, held, start, limits);
  FixedPointResult result{newton_answer(contact, law, held, start, limits), {}};
  if (const int left = systems_left(limits, result.answer);
      left > 0 && law.is_convex())
    result.answer.add(multiplier_method(contact, stiffness, law, held,
                                        limits.with_at_most(left)));
  for (const auto& path : {friction_path, spring_path})
    if (const int left = systems_left(limits, result.answer); left > 0)
      result.answer.add(path(contact, law, held, limits.with_at_most(left)));
  return result;
}

}  // namespace ffcontact
