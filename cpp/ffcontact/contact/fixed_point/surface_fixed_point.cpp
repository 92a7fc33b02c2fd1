// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point/surface_fixed_point.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/continuation/raised_friction.hpp"
#include "ffcontact/contact/fixed_point/normal_iterate.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Of Tresca's problem, which is convex.
constexpr int most_systems_a_bound = 60;

VectorXd normal_forces(const VectorXd& P) {
  return Map<const VectorXd, 0, Eigen::InnerStride<3>>(P.data(), P.size() / 3);
}

/// Tresca's problem, which has a solution that is unique in v.
ActiveSetResult with_given_bound(NewtonRelation& relation, const NodalLaw& law,
                                 const Flags& held, const ContactStates& state,
                                 const NewtonSettings& settings) {
  ActiveSetResult best =
      surface_newton(relation, law, held, state,
                     settings.with_at_most(std::min(settings.max_iterations,
                                                    most_systems_a_bound)));
  const int left = settings.max_iterations - best.iterations;
  if (best.status == ContactStatus::converged || left <= 0) return best;
  best.add(raised_friction(relation, law, held, settings.with_at_most(left)));
  return best;
}

}  // namespace

FixedPointResult surface_fixed_point(const CondensedContact& contact,
                                     const NodalLaw& law, const Flags& held,
                                     ContactStates state,
                                     const NewtonSettings& settings) {
  StepSolver solver;
  CondensedRelation relation(contact, solver);
  FixedPointResult result;
  ActiveSetResult& best = result.answer;
  best.violation = infinity;
  NormalIterate g(law.node_count());
  for (int systems = 0; systems < settings.max_iterations;) {
    ActiveSetResult step = with_given_bound(
        relation, with_given_slip_limit(law, g.value()), held, state,
        settings.with_at_most(settings.max_iterations - systems));
    systems += step.iterations;
    state = step.state;
    if (law.is_convex())
      g.stay();
    else
      g.move_towards(normal_forces(step.P.head(3 * law.node_count())));
    step.violation = surface_violation(relation, law, held, {step.P, step.v});
    const bool found = step.violation <= settings.tolerance;
    step.status =
        found ? ContactStatus::converged : ContactStatus::not_converged;
    if (step.violation < best.violation) best = std::move(step);
    best.iterations = systems;
    if (found || law.is_convex()) break;
  }
  result.history = g.history();
  return result;
}

}  // namespace ffcontact
