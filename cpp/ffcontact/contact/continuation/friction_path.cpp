// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/friction_path.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/continuation/friction_curve.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Newton is given this many linear systems.
constexpr int most_systems_at_an_end = 60;
constexpr double first_step = 0.02, longest_step = 0.1, shortest_step = 1e-7;
/// Steps that may turn at a kink.
constexpr double turning_step = 1e-2;
constexpr double longer = 1.5, shorter = 1. / 3;

class FrictionPath {
 public:
  FrictionPath(const CondensedContact& contact, const NodalLaw& law,
               const Flags& held, const NewtonSettings& settings,
               const ContactRows& start)
      : contact_(contact),
        law_(law),
        held_(held),
        settings_(settings),
        curve_(contact, law, held, start, settings.max_iterations) {
    best_.violation = infinity;
  }

  ActiveSetResult end() && {
    if (std::optional<Place> start = curve_.start()) {
      last_ = std::move(*start);
      while (goes_on()) step();
    }
    best_.iterations = curve_.systems();
    return std::move(best_);
  }

 private:
  using Place = FrictionCurve::Place;

  double share() const { return FrictionCurve::share(last_.z); }

  bool goes_on() const {
    return best_.status != ContactStatus::converged && h_ > shortest_step &&
           curve_.systems_left() > 0 && share() >= 0;
  }

  void step() {
    std::optional<Place> next = next_place();
    if (!next || (FrictionCurve::share(next->z) >= 1 && !ends(next->z))) {
      h_ *= shorter;
      return;
    }
    last_ = std::move(*next);
    h_ = std::min(longer * h_, longest_step);
  }

  std::optional<Place> next_place() {
    std::optional<Place> next = curve_.corrected(last_.z, last_.t, h_);
    if (next || h_ > turning_step) return next;
    return curve_.beyond_kink(last_, h_);
  }

  /// Newton from where the step passes s = 1.
  bool ends(const VectorXd& next) {
    const double t = (1 - share()) / (FrictionCurve::share(next) - share());
    StepSolver solver;
    ActiveSetResult end = surface_newton(
        contact_, law_, held_,
        FrictionCurve::rows(last_.z + t * (next - last_.z)), solver,
        settings_.with_at_most(
            std::min(curve_.systems_left(), most_systems_at_an_end)));
    curve_.spend(end.iterations);
    if (end.is_better_than(best_)) best_ = std::move(end);
    return best_.status == ContactStatus::converged;
  }

  const CondensedContact& contact_;
  const NodalLaw& law_;
  const Flags& held_;
  const NewtonSettings settings_;
  FrictionCurve curve_;
  Place last_;
  double h_ = first_step;
  ActiveSetResult best_;
};

}  // namespace

ActiveSetResult friction_path(const CondensedContact& contact,
                              const NodalLaw& law, const Flags& held,
                              const NewtonSettings& settings) {
  const int most = std::min(most_systems_at_an_end, settings.max_iterations);
  const ActiveSetResult start =
      surface_newton(contact, with_share_of_bound(law, 0), held,
                     all_stick(law.node_count()), settings.with_at_most(most));
  ActiveSetResult end;
  end.violation = infinity;
  if (start.status == ContactStatus::converged)
    end = FrictionPath(
              contact, law, held,
              settings.with_at_most(settings.max_iterations - start.iterations),
              {start.P, start.v})
              .end();
  end.iterations += start.iterations;
  return end;
}

}  // namespace ffcontact
