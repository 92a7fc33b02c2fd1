// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/compared.hpp"

#include "ffcontact/equilibrium/tractions/facet_loads.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

template <int d>
Compared<d> compared_change(const MatchedBodies<d>& bodies, double stress_terms,
                            const VectorXd& u_hat) {
  const SolvedBody<d>& body = bodies.body();
  Compared<d> change{u_hat - body.displacement, body.law, {}};
  change.law.gap.resize(0);
  change.law.previous = decltype(change.law.previous)();
  CellStresses<d>& stress = change.stress.mean;
  stress = stresses(bodies.topology().mesh, body.hooke, change.displacement);
  if (max_norm(stress) <= rounding_of_terms * stress_terms) {
    change.displacement.setZero();
    stress.setZero();
  }
  return change;
}

}  // namespace

template <int d>
Compared<d> compared(const MatchedBodies<d>& bodies, const StressTerms& terms,
                     const VectorXd& u_hat) {
  if (terms.unstressed) return compared_change(bodies, terms.stress, u_hat);
  const SimplexMesh<d>& mesh = bodies.topology().mesh;
  const SolvedBody<d>& body = bodies.body();
  Compared<d> result{u_hat, body.law, total_stresses(mesh, body, u_hat)};
  if (result.stress.varies())
    result.other_loads =
        difference_body_loads(mesh, body.body_loads, result.stress);
  return result;
}

template Compared<FFCONTACT_DIMENSION> compared(
    const MatchedBodies<FFCONTACT_DIMENSION>&, const StressTerms&,
    const VectorXd&);

}  // namespace ffcontact
