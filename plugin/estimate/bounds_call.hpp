// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/bounds/quantity_bounds.hpp"
//
#include "freefem/arguments.hpp"
#include "problem/contact_type.hpp"

namespace ffcontact::plugin {

/// A call of contactbounds.
struct BoundsCall {
  Stack stack;
  const NamedArguments& named;
  const std::vector<Expression>& q;  ///< of each body, or none

  /// If the script gives turns or sweeps there are as many, and one further turn.
  /// @param sweeps  that are right if the script says nothing
  /// @param steps   of relaxation in each of them
  BoundSettings settings(int sweeps, int steps) const {
    BoundSettings settings;
    settings.steps = count("steps", settings.steps);
    if (counts_turns()) {
      settings.turns = count("turns", 2);
      settings.further_turns = 1;
    }
    settings.relaxation.steps = steps * count("sweeps", sweeps);
    return settings;
  }
  bool reports() const {
    return named.verbosity_level(stack) >= 1 && mpirank == 0;
  }

 private:
  bool counts_turns() const {
    return named.given("turns") || named.given("sweeps");
  }
  int count(const char* name, int otherwise) const {
    return static_cast<int>(named.integer(stack, name, otherwise));
  }
};

/// contactbounds of what contactsolve found, of plane bodies and of solids.
/// @return (upper - lower) / |midpoint|
double plane_bounds(const BoundsCall& call, const ContactOf<2>& contact);
double solid_bounds(const BoundsCall& call, const ContactOf<3>& contact);

}  // namespace ffcontact::plugin
