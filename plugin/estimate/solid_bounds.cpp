// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/bounds_of.hpp"

namespace ffcontact::plugin {

double solid_bounds(const BoundsCall& call, const ContactOf<3>& contact) {
  return bounds_of(call, call.settings(4, steps_of_a_sweep<3>),
                   *contact.problem, judged_of(solved_contact(contact)));
}

}  // namespace ffcontact::plugin
