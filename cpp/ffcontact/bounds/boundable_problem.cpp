// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/boundable_problem.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/base/words.hpp"
#include "ffcontact/interface/curve_directions.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

bool has_friction(const ContactLaw& law) {
  return law.friction.maxCoeff() > 0 || max_norm(law.between_nodes.most) > 0;
}

/// Rounding beside a gap counts as none, and would beside displacements.
void require_near(const SolvedProblem<2>& solved) {
  constexpr double most = 1e3;
  const VectorXd& gap = solved.body.law.gap;
  Index worst = 0;
  if (gap.size() == 0 ||
      gap.maxCoeff(&worst) <= most * max_norm(solved.body.displacement))
    return;
  const Mesh& mesh = solved.topology.mesh;
  refuse("gap= is ", gap[worst], " at ",
         in_words(mesh.place(solved.contact.vertex[worst])),
         ", more than 1000 times the largest displacement: leave what nothing "
         "touches out of label=");
}

/// @throws std::invalid_argument  where the theorem does not hold, or is not used yet
void require_covered(const SolvedBody<2>& body) {
  const ContactLaw& law = body.law;
  if (law.bonded)
    refuse("there are no bounds of quantities of bonded bodies yet");
  if (law.limited() || (!law.tresca() && has_friction(law)))
    refuse(
        "bounds of quantities are strict for contact without friction and for "
        "Tresca's law alone: state the contact with slipbound=, e.g. that of "
        "the pressures found, or friction=0");
  if (law.layer.given() || !body.springs.empty() || body.tool)
    refuse(
        "there are no bounds of quantities with compliance=, spring=, push= or "
        "moment= yet");
}

/// @throws std::invalid_argument  where the construction does not succeed
void require_straight_and_admissible(const SolvedProblem<2>& solved,
                                     const Estimate<2>& first) {
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

}  // namespace

void require_boundable(const SolvedProblem<2>& solved,
                       const Estimate<2>& first) {
  require_covered(solved.body);
  require_near(solved);
  require_straight_and_admissible(solved, first);
}

}  // namespace ffcontact
