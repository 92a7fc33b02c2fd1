// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/continuation/spring_path.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/continuation/friction_path.hpp"
#include "ffcontact/contact/newton/surface_newton.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double first_springs = 1e-2, weaker = 0.1, weakest_springs = 5e-8;
/// Newton is given this many linear systems.
constexpr int most_systems_a_step = 60;
/// |v| relative to that on springs ten times as stiff, 1 of a body that stays and 10 of
/// one that slides.
constexpr double sliding = 1.5;

class SpringPath {
 public:
  SpringPath(const CondensedContact& contact, const NodalLaw& law,
             const Flags& held, const NewtonSettings& settings)
      : contact_(contact),
        law_(law),
        held_(held),
        settings_(settings),
        diagonal_(contact.S.diagonal()) {}

  ActiveSetResult end() && {
    put_springs(first_springs);
    take(surface_newton(contact_, law_, held_, all_stick(law_.node_count()),
                        limits(most_systems_a_step)));
    take_other_way();
    double eps = first_springs;
    while (on_springs() && eps > weakest_springs) weaken(eps *= weaker);
    if (on_springs())
      let_go();
    else
      last_.violation = infinity;
    last_.iterations = systems_;
    return std::move(last_);
  }

 private:
  bool on_springs() const { return last_.status == ContactStatus::converged; }

  NewtonSettings limits(int most) const {
    return settings_.with_at_most(
        std::min(most, settings_.max_iterations - systems_));
  }

  void put_springs(double eps) {
    contact_.S.diagonal() = (1 + eps) * diagonal_;
  }

  void weaken(double eps) {
    const double before = max_norm(last_.v);
    put_springs(eps);
    take_from_last();
    take_other_way();
    if (on_springs()) growth_ = max_norm(last_.v) / before;
  }

  void let_go() {
    put_springs(0);
    take_from_last();
    if (!on_springs() && growth_ > sliding)
      last_.status = ContactStatus::singular;
  }

  void take_from_last() {
    take(surface_newton(contact_, law_, held_, {last_.P, last_.v}, solver_,
                        limits(most_systems_a_step)));
  }

  /// Springs give friction_path a start.
  void take_other_way() {
    if (!on_springs())
      take(friction_path(contact_, law_, held_,
                         limits(settings_.max_iterations)));
  }

  void take(ActiveSetResult&& next) {
    systems_ += next.iterations;
    last_ = std::move(next);
  }

  CondensedContact contact_;  ///< on springs
  const NodalLaw& law_;
  const Flags& held_;
  const NewtonSettings settings_;
  const VectorXd diagonal_;  ///< of S
  StepSolver solver_;
  ActiveSetResult last_;
  double growth_ = 0;  ///< of |v| in the last step on springs
  int systems_ = 0;
};

}  // namespace

ActiveSetResult spring_path(const CondensedContact& contact,
                            const NodalLaw& law, const Flags& held,
                            const NewtonSettings& settings) {
  return SpringPath(contact, law, held, settings).end();
}

}  // namespace ffcontact
