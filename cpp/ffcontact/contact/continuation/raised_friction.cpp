// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/raised_friction.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double first_raise = 0.25, least_raise = 1e-4;
/// Newton is given this many linear systems.
constexpr int most_systems_a_raise = 30;

class RaisedFriction {
 public:
  RaisedFriction(NewtonRelation& relation, const NodalLaw& law,
                 const Flags& held, const NewtonSettings& settings)
      : relation_(relation), law_(law), held_(held), settings_(settings) {}

  ActiveSetResult end() && {
    last_ = at(0, all_stick(law_.node_count()));
    while (goes_on()) raise();
    if (share_ < 1) {
      last_.status = ContactStatus::not_converged;
      last_.violation = infinity;
    }
    last_.iterations = systems_;
    return std::move(last_);
  }

 private:
  template <class Start>
  ActiveSetResult at(double share, const Start& start) {
    ActiveSetResult answer = surface_newton(
        relation_, with_share_of_bound(law_, share), held_, start,
        settings_.with_at_most(std::min(systems_left(), most_systems_a_raise)));
    systems_ += answer.iterations;
    return answer;
  }

  int systems_left() const { return settings_.max_iterations - systems_; }

  bool goes_on() const {
    return last_.status == ContactStatus::converged && share_ < 1 &&
           by_ > least_raise && systems_left() > 0;
  }

  void raise() {
    const double share = std::min(share_ + by_, 1.0);
    ActiveSetResult next = at(share, ContactRows{last_.P, last_.v});
    const bool found = next.status == ContactStatus::converged;
    by_ *= found ? 2 : 0.5;
    if (!found) return;
    share_ = share;
    last_ = std::move(next);
  }

  NewtonRelation& relation_;
  const NodalLaw& law_;
  const Flags& held_;
  const NewtonSettings settings_;
  ActiveSetResult last_;
  double share_ = 0, by_ = first_raise;
  int systems_ = 0;
};

}  // namespace

ActiveSetResult raised_friction(NewtonRelation& relation, const NodalLaw& law,
                                const Flags& held,
                                const NewtonSettings& settings) {
  return RaisedFriction(relation, law, held, settings).end();
}

}  // namespace ffcontact
