// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bounds_by_turns.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/solve_contact.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr Index most_dofs_of_a_factor = 200000;
constexpr double share_of_rounding = 1e-14;
/// That is rounding beside the largest displacement.
constexpr double penetration = 1e-12;

}  // namespace

/// What the terms of l(v) and what is missed of equilibrium may add to a bound.
template <int d>
double BoundsByTurns<d>::rounding_of(const BoundPair<d>& pair, double t) const {
  const double terms = bounded_.matched_load.cwiseAbs().dot(pair.v.cwiseAbs()),
               missed = std::max(share_of_rounding, pair.defect),
               stress = bounded_.stress;
  return share_of_rounding * terms + missed * stress * stress / std::abs(t);
}

/// Under further loads.
template <int d>
auto BoundsByTurns<d>::solution(const ContactConditions<d>& of,
                                const VectorXd& more) {
  const auto& [topology, contact, system, solved] = bounded_.solved;
  system_.load = system.load + on_free_dofs(system, VectorXd(more));
  ++cost_.contact_problems;
  auto found =
      solve_contact(topology.mesh, of.contact, of.law, system_, settings_);
  settings_.stiffness = found.stiffness;
  return found;
}

template <int d>
BoundsByTurns<d>::BoundsByTurns(const BoundedQuantity<d>& bounded,
                                const ContactSettings& settings)
    : bounded_(bounded), settings_(settings), system_(bounded.solved.system) {
  settings_.stiffness = bounded.solved.body.stiffness;
  // multigrid has solved it: bounds take dozens of contact problems with one
  // matrix, and a factor pays where it has room
  if (settings_.stiffness || free_dof_count(system_) > most_dofs_of_a_factor)
    return;
  settings_.linear = LinearSolver::direct;
  solution({bounded.solved.contact, bounded.solved.body.law},
           VectorXd::Zero(bounded.load.size()));
}

template <int d>
OneBound<d> BoundsByTurns<d>::bound(double t, int turns,
                                    const RelaxationSettings& relaxation) {
  OneBound<d> bound{t};
  bound.pair.v = displacement_for(t, facet_densities(bounded_.first));
  for (int turn = 0; turn < turns; ++turn)
    bound = after_a_turn(bound, relaxation);
  return bound;
}

template <int d>
OneBound<d> BoundsByTurns<d>::after_a_turn(
    const OneBound<d>& before, const RelaxationSettings& relaxation) {
  OneBound<d> bound{before.t, stress_for(before, relaxation)};
  auto& [t, pair, value, rounding] = bound;
  pair.v = displacement_for(t, pair.rho);
  rounding = rounding_of(pair, t);
  value = std::copysign(1, t) * bounded_.of(pair.v) +
          excess(bounded_.bodies, pair, std::abs(t), bounded_.coulomb_terms()) +
          rounding;
  return bound;
}

/// v minimises the bound for rho, but for the rounding that keeps it clear.
template <int d>
VectorXd BoundsByTurns<d>::displacement_for(double t,
                                            const FacetDensities<d>& rho) {
  const MatchedBodies<d>& bodies = bounded_.bodies;
  const VectorXd load =
      bounded_.further_load - t * bounded_.load - nodal_forces<d>(bodies, rho);
  const auto found = solution(bounded_.sought, load);
  VectorXd v =
      cleared<d>(bodies, bounded_.clear, bodies.fields(found.displacement));
  if (depth_of<d>(bodies, bounded_.clear, v) > penetration * max_norm(v))
    refuse("no displacement that keeps clear was found");
  return v;
}

/// tau and rho that nearly minimise the bound for v.
template <int d>
BoundPair<d> BoundsByTurns<d>::stress_for(
    const OneBound<d>& bound, const RelaxationSettings& relaxation) {
  const auto& [topology, contact, system, solved] = bounded_.solved;
  const SolvedBody<d> body = loaded_body(bound.t, bound.pair.v);
  EstimateSettings<d> settings;
  settings.relaxation = relaxation;
  ++cost_.estimates;
  const Estimate<d> estimate =
      estimate_error<d>(topology, contact, system, body, settings);
  if (!estimate.admissible) refuse(estimate.reason);
  BoundPair<d> pair = pair_of(bounded_.bodies, body, estimate);
  add_quantity(bound.t, pair.tau);
  return pair;
}

/// Adds t q, which counted as an initial stress.
template <int d>
void BoundsByTurns<d>::add_quantity(double t,
                                    std::vector<SubcellStress<d>>& tau) const {
  const LinearStresses<d>& q = bounded_.matched.stress;
  if (q.empty()) return;
  for (std::size_t k = 0; k < tau.size(); ++k)
    tau[k] += t * subcell_values<d>(q.at_vertices(static_cast<int>(k)));
}

/// Contact under L + t l, reflected at v, whose vertices of the solved bodies come first; q
/// counts as an initial stress.
template <int d>
SolvedBody<d> BoundsByTurns<d>::loaded_body(double t, const VectorXd& v) {
  const auto& [topology, contact, system, solved] = bounded_.solved;
  const Quantity<d>& quantity = bounded_.quantity;
  SolvedBody<d> loaded = solved;
  loaded.neumann += t * quantity.tractions;
  loaded.body_loads += t * quantity.body_loads;
  loaded.initial = loaded.initial + -t * quantity.stress;
  loaded.law = reflected<d>(bounded_.solved, v.head(bounded_.load.size()));
  const auto found = solution({contact, loaded.law}, t * bounded_.load);
  loaded.displacement = found.displacement;
  loaded.multipliers = multipliers_of(found);
  return loaded;
}

template class BoundsByTurns<FFCONTACT_DIMENSION>;
}  // namespace ffcontact
