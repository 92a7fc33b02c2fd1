// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace ffcontact::plugin {

/// What data have beyond that which is judged exactly.
struct Oscillation {
  double force = 0;   ///< of the body forces (BodyForce)
  double strain = 0;  ///< of the initial strains and stresses (InitialStress)

  void add(const Oscillation& other) {
    force = std::hypot(force, other.force);
    strain = std::hypot(strain, other.strain);
  }
};

}  // namespace ffcontact::plugin
