// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/quantity_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffcontact/base/require.hpp"
#include "ffcontact/bounds/bound_pair.hpp"
#include "ffcontact/bounds/step_search.hpp"
#include "ffcontact/estimate/bodies/nodal_forces.hpp"
#include "ffcontact/estimate/displacement/admissible_displacement.hpp"
#include "ffcontact/interface/curve_directions.hpp"

namespace ffcontact {

namespace {

/// Steps that are too long for any equilibrium are shortened so often, by this factor.
constexpr int most_shortenings = 6;
constexpr double shortening = 4;

LinearStresses<2> times(double factor, LinearStresses<2> stress) {
  stress.mean *= factor;
  stress.variation *= factor;
  return stress;
}

/// @throws std::invalid_argument  where the theorem or the construction does not hold
void require_covered(const SolvedProblem<2>& solved, const Estimate<2>& first) {
  const SolvedBody<2>& body = solved.body;
  const ContactLaw& law = body.law;
  if (law.bonded)
    refuse("there are no bounds of quantities of bonded bodies yet");
  if (law.limited() || (!law.tresca() && law.friction.maxCoeff() > 0))
    refuse(
        "bounds of quantities are strict for contact without friction and for "
        "Tresca's law alone: state the contact with slipbound=, e.g. that of "
        "the pressures found, or friction=0");
  if (law.layer.given() || !body.springs.empty() || body.tool)
    refuse(
        "there are no bounds of quantities with compliance=, spring=, push= or "
        "moment= yet");
  if (turns(solved.contact))
    refuse(
        "there are no bounds of quantities where contact directions turn "
        "within edges: state corner=0, and the polygon is meant");
  if (first.refinement)
    refuse(
        "there are no bounds of quantities of bodies whose meshes do not match "
        "on the contact: let them have the same vertices there");
  if (!first.admissible)
    refuse("the estimate is not admissible: ", first.reason);
}

class BoundsByTurns {
 public:
  BoundsByTurns(const SolvedProblem<2>& solved, const Estimate<2>& first,
                const Quantity<2>& quantity, const BoundSettings& settings)
      : solved_(solved),
        first_(first),
        quantity_(quantity),
        settings_(settings),
        load_(load_of(solved.topology.mesh, quantity)),
        system_(solved.system) {
    settings_.contact.stiffness = solved.body.stiffness;
    settings_.contact.initial_state.clear();
  }

  QuantityBounds bounds() {
    QuantityBounds best;
    best.value = of(solved_.body.displacement);
    const VectorXd free = on_free_dofs(solved_.system, load_);
    if (free.isZero(0)) {  // of prescribed displacements
      best.lower = best.upper = best.value;
      best.local = VectorXd::Zero(solved_.topology.mesh.cell_count());
      return best;
    }
    longest_ = longest_step(free);
    find_steps(best);
    return best;
  }

 private:
  double of(const VectorXd& v) const {
    return load_.dot(v) + quantity_.constant;
  }

  /// At which stresses under s l are twice those under the loads, where contact holds what
  /// it touches, or six times on hat functions alone.
  double longest_step(const VectorXd& free) {
    const double stress =
        std::sqrt(energy_of(solved_, solved_.body.displacement));
    const VectorXd K = solved_.system.stiffness.diagonal();
    double hats = 0;
    for (Index k = 0; k < free.size(); ++k)
      if (free[k] != 0) hats += free[k] * free[k] / K[k];
    const double longest = 6 * stress / std::sqrt(hats),
                 held = std::sqrt(std::max(0.0, held_energy(free)));
    return 2 * stress < longest * held ? 2 * stress / held : longest;
  }

  /// Of a body that is glued to what it touches, under l alone.
  double held_energy(const VectorXd& free) {
    ElasticSystem alone = solved_.system;
    alone.load = free;
    alone.prescribed_value.setZero();
    const ContactLine& line = solved_.contact;
    return free.dot(solve_contact(solved_.topology.mesh, line,
                                  bonded_law(line.node_count()), alone,
                                  settings_.contact)
                        .displacement);
  }

  void find_steps(QuantityBounds& best) {
    StepSearch search(longest_);
    int tried = 0, shortened = 0;
    for (double s = longest_ / 4; s > 0 && tried < settings_.steps;) {
      const QuantityBounds found = at(s);
      const double width = found.upper - found.lower;
      if (std::isfinite(width)) {
        ++tried;
        search.add(s, width);
        if (width < best.upper - best.lower) best = found;
        s = search.next();
      } else if (tried > 0 || ++shortened > most_shortenings) {
        if (tried == 0) best.reason = found.reason;
        return;
      } else {
        s /= shortening;
      }
    }
  }

  QuantityBounds at(double s) {
    QuantityBounds found;
    found.value = of(solved_.body.displacement);
    found.step = s;
    try {
      const BoundPair plus = pair(s), minus = pair(-s);
      found.upper = of(plus.v) + excess(solved_, plus, s);
      found.lower = of(minus.v) - excess(solved_, minus, s);
      found.local = width_of_cells(solved_, plus, minus, s);
    } catch (const Refusal& refusal) {
      found.reason = refusal.what();
    } catch (const Failure& failure) {
      found.reason = failure.what();
    }
    return found;
  }

  BoundPair pair(double t) {
    BoundPair pair;
    pair.rho = first_.tractions;
    for (int turn = 0; turn < settings_.turns; ++turn) {
      pair.v = displacement_for(t, pair.rho);
      put_stress_for(t, pair);
    }
    pair.v = displacement_for(t, pair.rho);
    return pair;
  }

  /// That minimises the bound, but for the rounding of what keeps clear.
  VectorXd displacement_for(double t, const ContactDensities& rho) {
    const auto& [topology, line, system, body] = solved_;
    ContactLaw law = body.law;
    law.multiplier = Multiplier::force;
    law.slip_bound *= 2;
    law.between_nodes.least *= 2;
    law.between_nodes.most *= 2;
    const VectorXd u =
        solution(law, -t * load_ - nodal_forces(topology.mesh, line, rho))
            .displacement;
    return cleared_between_nodes(
        line, body.law,
        admissible_displacement(line, body.law, u, system.prescribed),
        system.prescribed);
  }

  /// tau and rho that nearly minimise the bound for v.
  void put_stress_for(double t, BoundPair& pair) {
    const auto& [topology, line, system, body] = solved_;
    SolvedBody<2> other = body;
    other.law = reflected(pair.v);
    const ContactSolution found = solution(other.law, t * load_);
    other.displacement = found.displacement;
    other.multipliers = found.pressure;
    other.neumann += t * quantity_.tractions;
    other.body_loads += t * quantity_.body_loads;
    other.initial = body.initial + times(-t, quantity_.stress);
    EstimateSettings<2> settings;
    settings.relaxation = settings_.relaxation;
    Estimate<2> estimate =
        estimate_error<2>(topology, line, system, other, settings);
    if (!estimate.admissible) refuse(estimate.reason);
    pair.rho = std::move(estimate.tractions);
    pair.tau = std::move(estimate.stress);
    if (quantity_.stress.empty()) return;
    for (int k = 0; k < topology.mesh.cell_count(); ++k)
      pair.tau[k] += t * subcell_values<2>(quantity_.stress.at_vertices(k));
  }

  /// The law with gap and load step before on the other side of what v has.
  ContactLaw reflected(const VectorXd& v) const {
    const ContactLine& line = solved_.contact;
    ContactLaw law = solved_.body.law;
    law.multiplier = Multiplier::force;
    const Matrix2Xd moved = contact_components(line, v);
    const VectorXd none = VectorXd::Zero(line.node_count());
    law.gap = 2 * (law.gap.size() > 0 ? law.gap : none) -
              VectorXd(moved.row(0).transpose());
    law.previous = 2 * (law.previous.size() > 0 ? law.previous : none) -
                   VectorXd(moved.row(1).transpose());
    return law;
  }

  /// Under further loads.
  ContactSolution solution(const ContactLaw& law, const VectorXd& more) {
    system_.load =
        solved_.system.load + on_free_dofs(solved_.system, VectorXd(more));
    ContactSolution found =
        solve_contact(solved_.topology.mesh, solved_.contact, law, system_,
                      settings_.contact);
    settings_.contact.stiffness = found.stiffness;
    return found;
  }

  const SolvedProblem<2>& solved_;
  const Estimate<2>& first_;
  const Quantity<2>& quantity_;
  BoundSettings settings_;
  VectorXd load_;         ///< l of the hat functions
  ElasticSystem system_;  ///< with other loads
  double longest_ = 0;
};

}  // namespace

QuantityBounds quantity_bounds(const SolvedProblem<2>& solved,
                               const Estimate<2>& first,
                               const Quantity<2>& quantity,
                               const BoundSettings& settings) {
  require_covered(solved, first);
  return BoundsByTurns(solved, first, quantity, settings).bounds();
}

}  // namespace ffcontact
