// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/fixed_point/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/active_set/convex_contact.hpp"
#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/contact/fixed_point/normal_iterate.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Newton from the states of a step is given this many linear systems.
constexpr int newton_systems = 10;

VectorXd normal_multipliers(const VectorXd& P) {
  return Map<const VectorXd, 0, Eigen::InnerStride<2>>(P.data(), P.size() / 2);
}

ContactState sliding_state(double vt) {
  return vt > 0   ? ContactState::slip_forward
         : vt < 0 ? ContactState::slip_backward
                  : ContactState::stick;
}

/// Where g is 0 P(g) is frictionless, and its states know no direction. Coulomb's law has
/// one as soon as P_n is not quite 0.
void follow_slip(const NodalLaw& law, const NodalLaw& given,
                 ActiveSetResult& answer) {
  for (std::size_t i = 0; i < answer.state.size(); ++i) {
    const int node = static_cast<int>(i);
    if (law.cone[node].frictionless() || !given.cone[node].frictionless() ||
        is_open(answer.state[i]))
      continue;
    answer.state[i] = sliding_state(answer.v[2 * node + 1]);
  }
}

/// A node that slips in P(g) without moving, where multipliers have more than one value,
/// sticks with Coulomb's law when its bound is above that of P(g).
void stick_below_bound(const CondensedContact& contact, const NodalLaw& law,
                       double tolerance, ActiveSetResult& answer) {
  const double rounding = tolerance * max_norm(answer.P),
               still = tolerance * motion_scale(contact, answer.v);
  for (Index i = 0; i < count_of(answer.state); ++i) {
    const double bound = law.cone[i].bound(answer.P[2 * i]);
    if (!is_open(answer.state[i]) && slip_sign(answer.state[i]) != 0 &&
        std::abs(answer.v[2 * i + 1]) <= still &&
        std::abs(answer.P[2 * i + 1]) < bound - rounding)
      answer.state[i] = ContactState::stick;
  }
}

/// The steps of the fixed point.
class Iteration {
 public:
  Iteration(const CondensedContact& contact, const NodalLaw& law,
            ContactStates state, const NewtonSettings& settings,
            bool with_newton)
      : contact_(contact),
        law_(law),
        settings_(settings),
        with_newton_(with_newton),
        state_(std::move(state)),
        g_(law.node_count()) {
    result_.answer.violation = infinity;
  }

  FixedPointResult result() && {
    while (left() > 0)
      if (step_ends()) break;
    result_.answer.iterations = systems_;
    result_.history = g_.history();
    return std::move(result_);
  }

 private:
  int left() const { return settings_.max_iterations - systems_; }

  /// @return whether the step, or Newton from its states, found the answer
  bool step_ends() {
    const NodalLaw given = with_given_slip_limit(law_, g_.value());
    // of whose steps nothing is told
    ActiveSetResult step =
        solve_convex(contact_, given, state_, {left(), settings_.tolerance});
    systems_ += step.iterations;
    const bool same_states = step.state == state_,
               slides = step.status == ContactStatus::singular;
    state_ = step.state;
    if (law_.is_convex())
      g_.stay();
    else
      g_.move_towards(normal_multipliers(step.P));
    if (keep(std::move(step))) {
      // the law at g is Coulomb's but for the last digits, or nothing slides
      follow_slip(law_, given, result_.answer);
      if (!law_.is_convex())
        stick_below_bound(contact_, law_, settings_.tolerance, result_.answer);
      put_into_law(law_, result_.answer.state, result_.answer.P);
      return true;
    }
    result_.answer.status =
        slides ? ContactStatus::singular : ContactStatus::not_converged;
    return with_newton_ && !same_states && left() > 0 && newton_ends();
  }

  /// Keeps a step that is the best so far. @return whether it is the answer
  bool keep(ActiveSetResult step) {
    const bool solved = step.status == ContactStatus::converged;
    step.violation = law_violation(contact_, law_, {step.P, step.v});
    tell(settings_.report,
         {"fixed point", count_of(g_.history()), "violation", step.violation});
    const bool found =
        solved && (law_.is_convex() || step.violation <= settings_.tolerance);
    if (found || step.violation < result_.answer.violation ||
        g_.history().size() == 1)
      result_.answer = std::move(step);
    return found;
  }

  bool newton_ends() {
    ActiveSetResult newton = active_set_newton(
        contact_, law_, state_,
        settings_.with_at_most(std::min(newton_systems, left())));
    systems_ += newton.iterations;
    if (newton.status != ContactStatus::converged) return false;
    result_.answer = std::move(newton);
    return true;
  }

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const NewtonSettings settings_;
  const bool with_newton_;
  ContactStates state_;
  NormalIterate g_;
  int systems_ = 0;  ///< solved so far
  FixedPointResult result_;
};

}  // namespace

FixedPointResult fixed_point(const CondensedContact& contact,
                             const NodalLaw& law, ContactStates state,
                             const NewtonSettings& settings, bool with_newton) {
  return Iteration(contact, law, std::move(state), settings, with_newton)
      .result();
}

}  // namespace ffcontact
