// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "ffcontact/bounds/boundable_problem.hpp"
//
#include "estimate/bounds_of.hpp"

namespace ffcontact::plugin {

namespace {

/// mu kappa, and what it rests on.
double friction_share(const BoundsCall& call, const ContactLine& line,
                      Judged<2>& judged) {
  const StuckNodes stuck = stuck_nodes_of(call.stack, call.named);
  factorise(line, judged);
  const auto [kappa, friction] = coulomb_constant_of(line, judged, stuck);
  if (call.reports())
    cout << "contactbounds: mu kappa " << friction * kappa << ", "
         << stuck_in_words(stuck)
         << ", strict if the exact solution slips the way u_h does" << endl;
  return friction * kappa;
}

}  // namespace

double plane_bounds(const BoundsCall& call, const ContactOf<2>& contact) {
  Judged<2> judged = judged_of(solved_contact(contact));
  BoundSettings settings = call.settings(8, 1);
  if (call.named.flag(call.stack, "coulomb") &&
      is_coulombs<2>(judged.body.law)) {
    settings.friction_share =
        friction_share(call, contact.problem->contact, judged);
    // turns gain more where mu kappa is near 1
    if (!call.named.given("turns")) ++settings.turns;
  }
  return bounds_of(call, settings, *contact.problem, std::move(judged));
}

}  // namespace ffcontact::plugin
