// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/compared.hpp"

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/estimate/bodies/total_stresses.hpp"
#include "ffcontact/estimate/bodies/unstressed.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

Compared compared(const MatchedBodies& bodies, const VectorXd& displacement) {
  const Mesh& mesh = bodies.topology().mesh;
  const SolvedBody<2>& body = bodies.body();
  Compared result{displacement, body.law,
                  total_stresses(mesh, body, displacement)};
  if (result.stress.varies())
    result.other_loads =
        difference_body_loads(mesh, body.body_loads, result.stress);
  return result;
}

Compared compared_change(const MatchedBodies& bodies, double stress_terms,
                         const VectorXd& u_hat) {
  const SolvedBody<2>& body = bodies.body();
  Compared change{u_hat - body.displacement, body.law, {}};
  change.law.gap.resize(0);
  change.law.previous.resize(0);
  Matrix3Xd& stress = change.stress.mean;
  stress = stresses(bodies.topology().mesh, body.hooke, change.displacement);
  if (max_norm(stress) <= rounding_of_terms * stress_terms) {
    change.displacement.setZero();
    stress.setZero();
  }
  return change;
}

}  // namespace ffcontact
