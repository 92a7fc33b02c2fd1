// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact::plugin {

/// What data have beyond that which is judged exactly.
struct Oscillation {
  double force = 0;   ///< of the body forces (BodyForce)
  double strain = 0;  ///< of the initial strains and stresses (InitialStress)
  /// of tractions beyond linear functions, over the largest traction [boundary]; empty:
  /// not asked for
  VectorXd bend{};

  void add(const Oscillation& other) {
    force = std::hypot(force, other.force);
    strain = std::hypot(strain, other.strain);
  }
};

}  // namespace ffcontact::plugin
