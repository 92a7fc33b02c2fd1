// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/stiffness.hpp"

namespace ffcontact::test {

/// u of a body without contact.
inline VectorXd displacement(const ElasticSystem& system) {
  const CondensedStiffness stiffness(system, {});
  return stiffness.extended(stiffness.condensed(system.load), VectorXd()) +
         system.prescribed_value;
}

/// Dofs that no support prescribes, in order.
inline std::vector<int> free_dofs(const ElasticSystem& system) {
  std::vector<int> dofs;
  for (int dof = 0; dof < system.dof_count(); ++dof)
    if (!system.prescribed[dof]) dofs.push_back(dof);
  return dofs;
}

}  // namespace ffcontact::test
