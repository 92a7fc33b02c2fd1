// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/problems.hpp"

namespace ffcontact::test {

/// A problem, its factorisation, the condensed relation with its law, and the states that
/// solvers start from.
struct Condensed {
  Problem problem;
  ElasticSystem system;
  CondensedStiffness stiffness;
  CondensedContact contact;
  NodalLaw law;
  std::vector<ContactState> sticking;

  explicit Condensed(const Problem& p)
      : problem(p),
        system(p.system()),
        stiffness(system, contact_dofs(p.line, system)),
        contact(condensed_contact(p.line, p.law, system, stiffness)),
        law(nodal_law(p.law, p.line)),
        sticking(p.line.node_count(), ContactState::stick) {}
};

}  // namespace ffcontact::test
