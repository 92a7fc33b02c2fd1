// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/bounded_quantity.hpp"

#include <cmath>

namespace ffcontact {

namespace {

template <int d>
Quantity<d> on_matched(const MatchedBodies<d>& bodies,
                       const SolvedBody<d>& solved,
                       const Quantity<d>& quantity) {
  SolvedBody<d> body = solved;
  body.neumann = quantity.tractions;
  body.body_loads = quantity.body_loads;
  body.initial = quantity.stress;
  body = bodies.matched(body);
  return {body.body_loads, body.initial, body.neumann, quantity.constant};
}

}  // namespace

template <int d>
BoundedQuantity<d> bounded_quantity(const SolvedProblem<d>& solved,
                                    const Estimate<d>& first,
                                    const Quantity<d>& quantity) {
  const MatchedBodies<d> bodies(solved);
  const SolvedBody<d>& body = bodies.body();
  const Quantity<d> matched = on_matched(bodies, solved.body, quantity);
  const VectorXd load = load_of(solved.topology.mesh, quantity),
                 matched_load = load_of(bodies.topology().mesh, matched);
  const double stress = std::sqrt(energy_of(bodies, body.displacement));
  return {solved,
          first,
          quantity,
          load,
          bodies,
          matched,
          matched_load,
          stress,
          {solved.contact, with_twice_the_bound<d>(solved.body.law)},
          {bodies.contact(), body.law},
          VectorXd::Zero(load.size())};
}

template BoundedQuantity<FFCONTACT_DIMENSION> bounded_quantity(
    const SolvedProblem<FFCONTACT_DIMENSION>&,
    const Estimate<FFCONTACT_DIMENSION>&, const Quantity<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
