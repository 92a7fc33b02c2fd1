// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/friction_cone.hpp"
#include "support/random.hpp"

namespace ffcontact::test {

/// Tresca's, or Coulomb's, in every other case with a limit; none in some cases.
inline FrictionCone any_cone(std::mt19937& random) {
  const Uniform value{0.1, 1};
  FrictionCone cone;
  const int kind = static_cast<int>(random() % 4);
  if (kind == 1) cone.cohesion = value(random);
  if (kind >= 2) cone.friction = value(random);
  if (kind == 3) cone.limit = value(random);
  return cone;
}

}  // namespace ffcontact::test
