// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "ffcontact/estimate/estimate.hpp"
//
#include "estimate/bounds_call.hpp"
#include "estimate/contact_error.hpp"
#include "estimate/estimate_outputs.hpp"
#include "estimate/goal.hpp"
#include "freefem/stopwatch.hpp"
#include "problem/systems.hpp"

namespace ffcontact::plugin {

template <int d>
void require_exact(const Oscillation& data, const SolvedBody<d>& body,
                   const Estimate<d>& first) {
  const double size = first.relative > 0 ? first.e / first.relative : infinity;
  if (vary_in_cells(data.force, body.body_loads) ||
      data.strain > linear_to * size)
    refuse(
        "bounds are strict for body forces that are constant in each cell, and "
        "initial strains and stresses that are linear: give bodyforce= and the "
        "varf such ones");
}

template <int d>
Quantity<d> checked_goal(const BoundsCall& call, const Bodies<d>& bodies,
                         const SolvedProblem<d>& solved) {
  Quantity<d> goal = read_goal<d>(call.stack, call.named, bodies, solved);
  if (call.q.empty()) return goal;
  bodies.require_bodies("q", call.q.size());
  const auto given = values_of<KN<double>*>(call.stack, call.q);
  for (std::size_t k = 0; k < given.size(); ++k)
    bodies.require_dofs("q", static_cast<int>(k), given[k]->N());
  require_goal<d>(bodies.joined.mesh, goal, joined_displacement(bodies, given));
  return goal;
}

inline void put(const BoundsCall& call, const std::vector<int>& first_cell,
                const QuantityBounds& bounds) {
  const auto& [stack, named, q] = call;
  const double midpoint = bounds.found() ? bounds.midpoint() : bounds.value;
  named.put(stack, "lower", bounds.lower);
  named.put(stack, "upper", bounds.upper);
  named.put(stack, "value", bounds.value);
  named.put(stack, "midpoint", midpoint);
  named.put(stack, "step", bounds.step);
  named.put(stack, "solves", static_cast<long>(bounds.cost.contact_problems));
  named.put(stack, "estimates", static_cast<long>(bounds.cost.estimates));
  VectorXd squares = VectorXd::Zero(first_cell.back());
  if (bounds.found() && midpoint != 0)
    squares = bounds.local.cwiseMax(0) / std::abs(midpoint);
  put_by_bodies(stack, named, first_cell, "eps", squares.cwiseSqrt());
}

inline void report(const QuantityBounds& bounds, double seconds) {
  cout << "contactbounds: ";
  if (bounds.found())
    cout << bounds.lower << " to " << bounds.upper << ", "
         << 100 * bounds.relative_width() << " % wide, u_h has "
         << bounds.value;
  else
    cout << "none, as " << bounds.reason;
  cout << ", " << bounds.cost.contact_problems << " contact problems, "
       << bounds.cost.estimates << " estimates, " << seconds << " s" << endl;
}

template <int d>
double bounds_of(const BoundsCall& call, const BoundSettings& settings,
                 const ContactProblem<d>& bodies, Judged<d> judged) {
  const Stopwatch watch;
  const Topology<d>& topology = bodies.topology();
  const LineOrSurface<d>& contact = bodies.contact;
  const ElasticSystem& system = *judged.system;
  SolvedBody<d>& body = judged.body;
  require_linear<d>(call.stack, call.named, bodies, "traction");
  const Oscillation data =
      read_material_and_loads<d>(call.stack, call.named, bodies, body);
  const SolvedProblem<d> solved{topology, contact, system, body};
  const Estimate<d> first = estimate_error<d>(topology, contact, system, body,
                                              settings_of_first<d>(settings));
  require_exact<d>(data, body, first);
  const QuantityBounds bounds = quantity_bounds<d>(
      solved, first, checked_goal<d>(call, bodies, solved), settings);
  put(call, bodies.joined.first_cell, bounds);
  if (call.reports()) report(bounds, watch.seconds());
  return bounds.relative_width();
}

}  // namespace ffcontact::plugin
