// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/bounds/bounded_quantity.hpp"
#include "ffcontact/bounds/bounds_cost.hpp"
#include "ffcontact/equilibrium/relaxation/relaxation_settings.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// A bound of l for t = s, of -l for t = -s.
template <int d>
struct OneBound {
  double t;
  BoundPair<d> pair{};
  double value = infinity;  ///< no less than l(u), or than -l(u)
  double rounding = 0;      ///< that is in it
};

/// Bounds by pairs (v, tau, rho) that improve in turns. With given rho
///     v  minimises the bound: contact under L - t l - rho, slip bound 2 k;
/// with given v
///     tau, rho  nearly do: the estimate of contact under L + t l with 2 gap - v_n for the
///               gap and 2 previous - v_t for the load step before.
/// A turn is the second and then the first.
template <int d>
class BoundsByTurns {
 public:
  /// @param bounded  stays where it is
  BoundsByTurns(const BoundedQuantity<d>& bounded,
                const ContactSettings& settings);

  /// From rho of the estimate on.
  /// @throws Refusal, Failure  where L + t l leaves no equilibrium, among others
  OneBound<d> bound(double t, int turns, const RelaxationSettings& relaxation);

  /// By one more turn, from v of a bound on.
  OneBound<d> after_a_turn(const OneBound<d>& before,
                           const RelaxationSettings& relaxation);

  /// Null where the bodies are too large for one.
  const CondensedStiffness* factor() const { return settings_.stiffness.get(); }
  /// Of all bounds so far, with those that were refused.
  const BoundsCost& cost() const { return cost_; }

 private:
  double rounding_of(const BoundPair<d>& pair, double t) const;
  void add_quantity(double t, std::vector<SubcellStress<d>>& tau) const;
  auto solution(const ContactConditions<d>& of, const VectorXd& more);
  VectorXd displacement_for(double t, const FacetDensities<d>& rho);
  SolvedBody<d> loaded_body(double t, const VectorXd& v);
  BoundPair<d> stress_for(const OneBound<d>& bound,
                          const RelaxationSettings& relaxation);

  const BoundedQuantity<d>& bounded_;
  ContactSettings settings_;
  ElasticSystem system_;  ///< with other loads
  BoundsCost cost_;
};

}  // namespace ffcontact
