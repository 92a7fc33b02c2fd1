// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/boundable_problem.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Rounding beside a gap counts as none, and would beside displacements.
template <int d>
void require_near(const SolvedProblem<d>& solved) {
  constexpr double most = 1e3;
  const VectorXd& gap = solved.body.law.gap;
  Index worst = 0;
  if (gap.size() == 0 ||
      gap.maxCoeff(&worst) <= most * max_norm(solved.body.displacement))
    return;
  const SimplexMesh<d>& mesh = solved.topology.mesh;
  refuse("gap= is ", gap[worst], " at ",
         in_words(mesh.place(solved.contact.vertex[worst])),
         ", more than 1000 times the largest displacement: leave what nothing "
         "touches out of label=");
}

/// @throws std::invalid_argument  where the theorem does not hold, or is not used yet
template <int d>
void require_covered(const SolvedBody<d>& body, bool for_coulomb) {
  const ContactLaw<d>& law = body.law;
  if (law.has_bonded())
    refuse("there are no bounds of quantities of bonded bodies yet");
  const bool limited = law.shear_limit.size() > 0,
             with_hypothesis = for_coulomb && d == 2 && !limited;
  if (limited || (is_coulombs<d>(law) && !with_hypothesis))
    refuse(
        "bounds of quantities are strict for contact without friction and for "
        "Tresca's law alone: state the contact with slipbound=, e.g. that of "
        "the pressures found, or friction=0; of plane bodies without a shear "
        "limit, coulomb=true takes Coulomb's law under a hypothesis");
  if (law.layer.given() || body.tool)
    refuse(
        "there are no bounds of quantities with compliance=, push= or moment= "
        "yet");
}

}  // namespace

template <int d>
bool is_coulombs(const ContactLaw<d>& law) {
  if (law.slip_bound.size() > 0) return false;
  if constexpr (d == 2)
    if (max_norm(law.between_nodes.most) > 0) return true;
  return law.friction.maxCoeff() > 0;
}

template <int d>
void require_boundable(const SolvedProblem<d>& solved, const Estimate<d>& first,
                       bool for_coulomb) {
  require_covered(solved.body, for_coulomb);
  require_near(solved);
  if (!first.admissible)
    refuse("the estimate is not admissible: ", first.reason);
}

template void require_boundable(const SolvedProblem<FFCONTACT_DIMENSION>&,
                                const Estimate<FFCONTACT_DIMENSION>&, bool);
template bool is_coulombs<FFCONTACT_DIMENSION>(
    const ContactLaw<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
