// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/bounds/bound_pair.hpp"
#include "ffcontact/bounds/boundable_problem.hpp"
#include "ffcontact/bounds/coulomb_on_line.hpp"
#include "ffcontact/bounds/longest_step.hpp"
#include "ffcontact/bounds/step_search.hpp"
#include "ffcontact/contact/residual_defect.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A step that is too long for any equilibrium is shortened so often, by this factor.
constexpr int most_shortenings = 6;
constexpr double shortening = 4;
constexpr Index most_dofs_of_a_factor = 200000;
constexpr double share_of_rounding = 1e-14;
/// That is rounding beside the largest displacement.
constexpr double penetration = 1e-12;

void require_valid(const BoundSettings& settings) {
  if (settings.steps < 1 || settings.turns < 1)
    refuse("steps and turns must be at least 1, got ", settings.steps, " and ",
           settings.turns);
  require_valid(settings.relaxation);
}

template <int d>
class BoundsByTurns {
 public:
  BoundsByTurns(const SolvedProblem<d>& solved, const Estimate<d>& first,
                const Quantity<d>& quantity, const BoundSettings& settings)
      : solved_(solved),
        bodies_(solved),
        first_(first),
        quantity_(quantity),
        matched_(matched(quantity)),
        settings_(settings),
        load_(load_of(solved.topology.mesh, quantity)),
        matched_load_(load_of(bodies_.topology().mesh, matched_)),
        system_(solved.system),
        stress_(std::sqrt(energy_of(bodies_, bodies_.body().displacement))),
        sought_{solved.contact, with_twice_the_bound<d>(solved.body.law)},
        clear_{bodies_.contact(), bodies_.body().law},
        further_load_(VectorXd::Zero(load_.size())) {
    settings_.contact.stiffness = solved.body.stiffness;
  }

  QuantityBounds none_as(std::string reason) const {
    QuantityBounds bounds = none(0);
    bounds.reason = std::move(reason);
    return bounds;
  }

  /// Of bodies whose law is with_bound_of.
  /// @param law  Coulomb's
  void put_coulomb(const ContactLaw<d>& law) {
    const VectorXd& u_hat = first_.displacement;
    coulomb_ = coulomb_terms(bodies_, first_, *settings_.friction_share);
    sought_ = clear_ = conditions_of_coulomb(solved_.contact, law, u_hat);
    further_load_ = coulomb_->share *
                    (nodal_forces<d>(bodies_, facet_densities(first_)) -
                     force_residual(solved_.system, u_hat, further_load_));
  }

  QuantityBounds bounds() {
    const VectorXd free = on_free_dofs(solved_.system, load_);
    const std::string reason = reason_against(free);
    if (!reason.empty()) return none_as(reason);
    factorise();
    longest_ = longest_step(solved_.system, settings_.contact.stiffness.get(),
                            free, stress_);
    return narrowest();
  }

 private:
  /// The quantity on bodies whose traces match.
  Quantity<d> matched(const Quantity<d>& quantity) const {
    SolvedBody<d> body = solved_.body;
    body.neumann = quantity.tractions;
    body.body_loads = quantity.body_loads;
    body.initial = quantity.stress;
    body = bodies_.matched(body);
    return {body.body_loads, body.initial, body.neumann, quantity.constant};
  }

  std::string reason_against(const VectorXd& free) const {
    if (free.isZero(0))
      return "no free vertex of the mesh moves it: prescribed displacements "
             "say what it is, or the mesh is too coarse";
    return stress_ == 0 ? "the loads make no stresses" : "";
  }

  /// There are no bounds at a step yet.
  QuantityBounds none(double s) const {
    QuantityBounds bounds;
    bounds.value = of(bodies_.body().displacement);
    bounds.step = s;
    return bounds;
  }

  double of(const VectorXd& v) const {
    return matched_load_.dot(v) + matched_.constant;
  }

  /// What multigrid has solved: bounds take dozens of contact problems with one matrix, and a
  /// factor pays where it has room.
  void factorise() {
    if (settings_.contact.stiffness ||
        free_dof_count(system_) > most_dofs_of_a_factor)
      return;
    settings_.contact.linear = LinearSolver::direct;
    solution({solved_.contact, solved_.body.law}, VectorXd::Zero(load_.size()));
  }

  /// What the terms of l(v) and what is missed of equilibrium may add to a bound.
  double rounding_of(const BoundPair<d>& pair, double s) const {
    const double terms = matched_load_.cwiseAbs().dot(pair.v.cwiseAbs());
    return share_of_rounding * terms +
           std::max(share_of_rounding, pair.defect) * stress_ * stress_ / s;
  }

  QuantityBounds narrowest() {
    QuantityBounds best = none(0);
    double s = longest_ / 4;
    for (int k = 0; k <= most_shortenings; ++k, s /= shortening) {
      best = at(s);
      if (best.found()) return searched(best);
    }
    return best;
  }

  /// From the bounds of a first step on.
  QuantityBounds searched(QuantityBounds best) {
    StepSearch search(longest_);
    search.add(best.step, best.width());
    double s = search.next();
    for (int k = 1; s > 0 && k < settings_.steps; ++k) {
      const QuantityBounds bounds = at(s);
      if (!bounds.found()) break;
      search.add(s, bounds.width());
      if (bounds.width() < best.width()) best = bounds;
      s = search.next();
    }
    return polished(best);
  }

  /// With a further turn, and twice as many sweeps.
  QuantityBounds polished(const QuantityBounds& best) {
    ++settings_.turns;
    settings_.relaxation = with_twice_the_sweeps(settings_.relaxation);
    const QuantityBounds bounds = at(best.step);
    return bounds.width() < best.width() ? bounds : best;
  }

  QuantityBounds at(double s) {
    QuantityBounds bounds = none(s);
    try {
      put_bounds(bounds);
    } catch (const Refusal& refusal) {
      bounds.reason = refusal.what();
    } catch (const Failure& failure) {
      bounds.reason = failure.what();
    }
    return bounds;
  }

  void put_bounds(QuantityBounds& bounds) {
    const double s = bounds.step;
    const BoundPair<d> plus = pair(s), minus = pair(-s);
    const double above = rounding_of(plus, s), below = rounding_of(minus, s);
    const CoulombTerms<d>* coulomb = coulomb_ ? &*coulomb_ : nullptr;
    bounds.upper = of(plus.v) + excess(bodies_, plus, s, coulomb) + above;
    bounds.lower = of(minus.v) - excess(bodies_, minus, s, coulomb) - below;
    bounds.local =
        bodies_.sums_of_parts(width_of_cells(bodies_, plus, minus, s, coulomb))
            .array() +
        (above + below) / solved_.topology.mesh.cell_count();
  }

  BoundPair<d> pair(double t) {
    BoundPair<d> pair;
    pair.rho = facet_densities(first_);
    for (int turn = 0; turn < settings_.turns; ++turn) {
      pair.v = displacement_for(t, pair.rho);
      put_stress_for(t, pair);
    }
    pair.v = displacement_for(t, pair.rho);
    return pair;
  }

  /// v minimises the bound for rho, but for the rounding that keeps it clear.
  VectorXd displacement_for(double t, const FacetDensities<d>& rho) {
    const auto found =
        solution(sought_, further_load_ - t * load_ -
                              VectorXd(nodal_forces<d>(bodies_, rho)));
    VectorXd v =
        cleared<d>(bodies_, clear_, bodies_.fields(found.displacement));
    if (depth_of<d>(bodies_, clear_, v) > penetration * max_norm(v))
      refuse("no displacement that keeps clear was found");
    return v;
  }

  /// tau and rho that nearly minimise the bound for v.
  void put_stress_for(double t, BoundPair<d>& pair) {
    const SolvedBody<d> body = loaded_body(t, pair.v);
    EstimateSettings<d> settings;
    settings.relaxation = settings_.relaxation;
    const Estimate<d> estimate = estimate_error<d>(
        solved_.topology, solved_.contact, solved_.system, body, settings);
    if (!estimate.admissible) refuse(estimate.reason);
    pair.defect = std::max(estimate.equilibrium.largest(), estimate.cone);
    pair.rho = facet_densities(estimate);
    pair.springs = estimate.spring_tractions;
    pair.oscillation = estimate.oscillation;
    pair.tau.resize(bodies_.topology().mesh.cell_count());
    for (std::size_t k = 0; k < pair.tau.size(); ++k)
      pair.tau[k] = stress_in(static_cast<int>(k), t, body, estimate);
  }

  SubcellStress<d> stress_in(int cell, double t, const SolvedBody<d>& body,
                             const Estimate<d>& estimate) const {
    SubcellStress<d> stress = stress_of(solved_.topology, estimate, body, cell);
    if (!matched_.stress.empty())
      stress += t * subcell_values<d>(matched_.stress.at_vertices(cell));
    return stress;
  }

  /// Contact under L + t l, reflected at v, whose vertices of the solved bodies come first; q counts as an initial stress.
  SolvedBody<d> loaded_body(double t, const VectorXd& v) {
    SolvedBody<d> loaded = solved_.body;
    loaded.neumann += t * quantity_.tractions;
    loaded.body_loads += t * quantity_.body_loads;
    loaded.initial = loaded.initial + -t * quantity_.stress;
    loaded.law = reflected<d>(solved_, v.head(load_.size()));
    const auto found = solution({solved_.contact, loaded.law}, t * load_);
    loaded.displacement = found.displacement;
    loaded.multipliers = multipliers_of(found);
    return loaded;
  }

  /// Under further loads.
  auto solution(const ContactConditions<d>& of, const VectorXd& more) {
    system_.load =
        solved_.system.load + on_free_dofs(solved_.system, VectorXd(more));
    auto found = solve_contact(solved_.topology.mesh, of.contact, of.law,
                               system_, settings_.contact);
    settings_.contact.stiffness = found.stiffness;
    return found;
  }

  const SolvedProblem<d>& solved_;
  MatchedBodies<d> bodies_;
  const Estimate<d>& first_;
  const Quantity<d>& quantity_;
  Quantity<d> matched_;  ///< the quantity on the matched bodies
  BoundSettings settings_;
  VectorXd load_;  ///< l of the hat functions of the solved bodies
  VectorXd matched_load_;
  ElasticSystem system_;  ///< with other loads
  double stress_;         ///< |sigma_h|
  /// under which v is sought, and which it keeps to on the matched bodies
  ContactConditions<d> sought_, clear_;
  VectorXd further_load_;  ///< under which v is sought
  std::optional<CoulombTerms<d>> coulomb_{};
  double longest_ = 0;
};

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
  BoundsByTurns<d> bounds(problem, first, quantity, settings);
  const double share = *settings.friction_share;
  if (!(share < 1))
    return bounds.none_as("mu kappa is " + in_digits(share) +
                          ", and Coulomb's law has bounds below 1 alone");
  bounds.put_coulomb(body.law);
  return bounds.bounds();
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
  return BoundsByTurns<d>(solved, first, quantity, settings).bounds();
}

template QuantityBounds quantity_bounds(
    const SolvedProblem<FFCONTACT_DIMENSION>&,
    const Estimate<FFCONTACT_DIMENSION>&, const Quantity<FFCONTACT_DIMENSION>&,
    const BoundSettings&);

}  // namespace ffcontact
