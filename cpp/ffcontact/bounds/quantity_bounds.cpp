// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/bounds/boundable_problem.hpp"
#include "ffcontact/bounds/bounds_by_turns.hpp"
#include "ffcontact/bounds/coulomb_on_line.hpp"
#include "ffcontact/bounds/longest_step.hpp"
#include "ffcontact/bounds/step_search.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A step that is too long for any equilibrium is shortened so often, by this factor.
constexpr int most_shortenings = 6;
constexpr double shortening = 4;
/// What a further turn of both bounds has to gain of the width.
constexpr double worth_of_a_turn = 0.02;

void require_valid(const BoundSettings& settings) {
  if (settings.steps < 1 || settings.turns < 1)
    refuse("steps and turns must be at least 1, got ", settings.steps, " and ",
           settings.turns);
  require_valid(settings.relaxation);
}

/// Both bounds at a step; infinite where there are none, for a reason.
template <int d>
struct BoundsOfStep {
  OneBound<d> plus, minus;
  std::string reason{};

  double step() const { return plus.t; }
  double width() const { return plus.value + minus.value; }
  double rounding() const { return plus.rounding + minus.rounding; }
  bool found() const { return std::isfinite(width()); }
};

/// @return why it was refused; nothing if it was not
template <class Run>
std::string reason_against(const Run& run) {
  try {
    run();
    return "";
  } catch (const Refusal& refusal) {
    return refusal.what();
  } catch (const Failure& failure) {
    return failure.what();
  }
}

/// Of its estimate, for s = 1.
template <int d>
double excess_of_solution(const BoundedQuantity<d>& bounded) {
  const BoundPair<d> pair =
      pair_of(bounded.bodies, bounded.solved.body, bounded.first);
  return excess(bounded.bodies, pair, 1, bounded.coulomb_terms());
}

/// Looks for the narrowest bounds.
template <int d>
class SearchOfBounds {
 public:
  SearchOfBounds(const BoundedQuantity<d>& bounded,
                 const BoundSettings& settings)
      : settings_(settings),
        turns_(bounded, settings.contact),
        longest_(longest_step(bounded.solved.system, turns_.factor(),
                              on_free_dofs(bounded.solved.system, bounded.load),
                              bounded.stress)),
        error_(2 * excess_of_solution(bounded)) {}

  BoundsOfStep<d> narrowest() {
    BoundsOfStep<d> best = first();
    if (!best.found()) return best;
    best = narrowest_from(std::move(best));
    improve(best);
    return best;
  }

  const BoundsCost& cost() const { return turns_.cost(); }

 private:
  OneBound<d> one_bound(double t) {
    return turns_.bound(t, settings_.turns, settings_.relaxation);
  }

  BoundsOfStep<d> at(double s) {
    BoundsOfStep<d> bounds{{s}, {-s}};
    bounds.reason = reason_against([&] {
      bounds.plus = one_bound(s);
      bounds.minus = one_bound(-s);
    });
    return bounds;
  }

  /// At the first step that is short enough.
  BoundsOfStep<d> first() {
    double s = longest_ / 4;
    BoundsOfStep<d> bounds = at(s);
    for (int k = 0; k < most_shortenings && !bounds.found(); ++k)
      bounds = at(s /= shortening);
    return bounds;
  }

  /// At this step and those that StepSearch has tried from it.
  BoundsOfStep<d> narrowest_from(BoundsOfStep<d> best) {
    StepSearch search(longest_, error_);
    search.add(best.step(), best.width());
    double s = search.next();
    for (int k = 1; s > 0 && k < settings_.steps; ++k) {
      BoundsOfStep<d> bounds = at(s);
      if (!bounds.found()) break;
      search.add(s, bounds.width());
      if (bounds.width() < best.width()) best = std::move(bounds);
      s = search.next();
    }
    return best;
  }

  /// Each bound for itself: often one has much farther to go. It is kept where a turn is
  /// refused.
  void improve(BoundsOfStep<d>& best) {
    const double least_gain = worth_of_a_turn / 2 * best.width();
    for (OneBound<d>* bound : {&best.plus, &best.minus})
      reason_against([&] { improve(least_gain, *bound); });
  }

  /// By further turns with twice the sweeps each, as long as one gains enough.
  void improve(double least_gain, OneBound<d>& bound) {
    RelaxationSettings relaxation = settings_.relaxation;
    double gain = infinity;
    for (int k = 0; k < settings_.further_turns && gain > least_gain; ++k) {
      relaxation = with_twice_the_sweeps(relaxation);
      gain = gain_of_a_turn(relaxation, bound);
    }
  }

  /// What a turn takes off a bound; one that takes off nothing is left out.
  double gain_of_a_turn(const RelaxationSettings& relaxation,
                        OneBound<d>& bound) {
    OneBound<d> next = turns_.after_a_turn(bound, relaxation);
    const double gain = bound.value - next.value;
    if (gain > 0) bound = std::move(next);
    return gain;
  }

  BoundSettings settings_;
  BoundsByTurns<d> turns_;
  double longest_;
  double error_;  ///< widths are near error_ / s on short steps
};

template <int d>
QuantityBounds none(const BoundedQuantity<d>& bounded, std::string reason) {
  QuantityBounds bounds;
  bounds.value = bounded.of_solution();
  bounds.reason = std::move(reason);
  return bounds;
}

template <int d>
VectorXd contributions(const BoundedQuantity<d>& bounded,
                       const BoundsOfStep<d>& bounds) {
  const auto& [plus, minus, reason] = bounds;
  const VectorXd of_cells =
      width_of_cells(bounded.bodies, plus.pair, minus.pair, bounds.step(),
                     bounded.coulomb_terms());
  return bounded.bodies.sums_of_parts(of_cells).array() +
         bounds.rounding() / bounded.solved.topology.mesh.cell_count();
}

template <int d>
QuantityBounds narrowest_bounds(const BoundedQuantity<d>& bounded,
                                const BoundSettings& settings) {
  SearchOfBounds<d> search(bounded, settings);
  const BoundsOfStep<d> best = search.narrowest();
  QuantityBounds bounds = none(bounded, best.reason);
  bounds.cost = search.cost();
  bounds.step = best.step();
  if (!best.found()) return bounds;
  bounds.upper = best.plus.value;
  bounds.lower = -best.minus.value;
  bounds.local = contributions(bounded, best);
  return bounds;
}

/// @return nothing if there may be bounds
template <int d>
std::string reason_for_none(const BoundedQuantity<d>& bounded) {
  if (on_free_dofs(bounded.solved.system, bounded.load).isZero(0))
    return "no free vertex of the mesh moves it: prescribed displacements "
           "say what it is, or the mesh is too coarse";
  return bounded.stress == 0 ? "the loads make no stresses" : "";
}

template <int d>
QuantityBounds bounds_of(const BoundedQuantity<d>& bounded,
                         const BoundSettings& settings) {
  const std::string reason = reason_for_none(bounded);
  return reason.empty() ? narrowest_bounds(bounded, settings)
                        : none(bounded, reason);
}

template <int d>
QuantityBounds bounds_with_coulomb(const SolvedProblem<d>& solved,
                                   const Estimate<d>& first,
                                   const Quantity<d>& quantity,
                                   const BoundSettings& settings) {
  require_coulomb_covered(solved, first);
  const auto& [topology, contact, system, body] = solved;
  SolvedBody<d> known = body;
  known.law = with_bound_of(body.law, contact, first.tractions);
  const SolvedProblem<d> problem{topology, contact, system, known};
  const BoundedQuantity<d> bounded = bounded_quantity(problem, first, quantity);
  const double share = *settings.friction_share;
  if (!(share < 1))
    return none(bounded, "mu kappa is " + in_digits(share) +
                             ", and Coulomb's law has bounds below 1 alone");
  return bounds_of(with_coulombs_law(bounded, body.law, share), settings);
}

}  // namespace

template <int d>
QuantityBounds quantity_bounds(const SolvedProblem<d>& solved,
                               const Estimate<d>& first,
                               const Quantity<d>& quantity,
                               const BoundSettings& settings) {
  require_valid(settings);
  require_boundable(solved, first, settings.friction_share.has_value());
  if constexpr (d == 2)
    if (is_coulombs<2>(solved.body.law))
      return bounds_with_coulomb<d>(solved, first, quantity, settings);
  return bounds_of(bounded_quantity(solved, first, quantity), settings);
}

template QuantityBounds quantity_bounds(
    const SolvedProblem<FFCONTACT_DIMENSION>&,
    const Estimate<FFCONTACT_DIMENSION>&, const Quantity<FFCONTACT_DIMENSION>&,
    const BoundSettings&);

}  // namespace ffcontact
