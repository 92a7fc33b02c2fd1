// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/surface_answer.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/contact/surface_fixed_point.hpp"
#include "ffcontact/contact/surface_newton.hpp"

namespace ffcontact {

namespace {

/// Violation of an answer by a factor in single precision before it is corrected.
constexpr double tolerance_to_be_corrected = 1e-6;
/// Newton is given this many linear systems before the fixed point goes on.
constexpr int most_newton_systems = 100;

/// Newton from the given states, and where these lead nowhere from sticking nodes.
ActiveSetResult newton_answer(const CondensedContact& contact,
                              const NodalLaw& law,
                              const std::vector<char>& held,
                              const std::vector<ContactState>& start,
                              const NewtonSettings& limits) {
  const std::vector<ContactState> stick(law.node_count(), ContactState::stick);
  const auto first_of = [&limits](int left) {
    return limits.with_at_most(std::min(most_newton_systems, left));
  };
  ActiveSetResult best = surface_newton(contact, law, held, start,
                                        first_of(limits.max_iterations));
  const int left = limits.max_iterations - best.iterations;
  if (best.status == ContactStatus::converged || left <= 0 || start == stick)
    return best;
  ActiveSetResult again =
      surface_newton(contact, law, held, stick, first_of(left));
  const int systems = best.iterations + again.iterations;
  if (again.is_better_than(best)) best = std::move(again);
  best.iterations = systems;
  return best;
}

std::vector<ContactState> first_states(const NodalLaw& law,
                                       const ContactSettings& settings) {
  if (!settings.initial_state.empty()) return settings.initial_state;
  return std::vector<ContactState>(law.node_count(), ContactState::stick);
}

}  // namespace

ActiveSetResult rough_answer(const CondensedContact& contact,
                             const NodalLaw& law, const std::vector<char>& held,
                             const std::optional<ContactRows>& near,
                             const ContactSettings& settings,
                             StepSolver& solver) {
  const double enough = std::max(settings.tolerance, tolerance_to_be_corrected);
  const NewtonSettings limits{
      std::min(most_newton_systems, settings.max_iterations),
      enough,
      {},
      enough};
  return near ? surface_newton(contact, law, held, *near, solver, limits)
              : surface_newton(contact, law, held, first_states(law, settings),
                               solver, limits);
}

FixedPointResult surface_answer(const CondensedContact& contact,
                                const NodalLaw& law,
                                const std::vector<char>& held,
                                const ContactSettings& settings) {
  const std::vector<ContactState> start = first_states(law, settings);
  const NewtonSettings limits{settings.max_iterations, settings.tolerance};
  if (settings.solver == ContactSolver::fixed_point)
    return surface_fixed_point(contact, law, held, start, limits);
  FixedPointResult newton{newton_answer(contact, law, held, start, limits), {}};
  const int left = limits.max_iterations - newton.answer.iterations;
  if (newton.answer.status == ContactStatus::converged || left <= 0)
    return newton;
  FixedPointResult path =
      surface_fixed_point(contact, law, held, start, limits.with_at_most(left));
  const int systems = newton.answer.iterations + path.answer.iterations;
  if (path.answer.is_better_than(newton.answer)) newton = std::move(path);
  newton.answer.iterations = systems;
  return newton;
}

}  // namespace ffcontact
