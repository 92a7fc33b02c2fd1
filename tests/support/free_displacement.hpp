// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/condensed_stiffness.hpp"

namespace ffcontact::test {

/// u of a body without contact.
inline VectorXd displacement(const ElasticSystem& system) {
  const CondensedStiffness stiffness(system, {});
  return stiffness.extended(stiffness.condensed(system.load), VectorXd()) +
         system.prescribed_value;
}

}  // namespace ffcontact::test
