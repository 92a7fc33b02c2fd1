// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

struct RelaxationSettings {
  /// at most; fewer where one no longer lowers e. Without a number 2 in the plane, 16 in
  /// space, and further ones while these are worth their time
  std::optional<int> steps{};
  /// stop when the last step lowered e by less than this fraction; 0: do all steps
  double tightness = 0;
};

/// @throws std::invalid_argument  unless steps >= 0 and 0 <= tightness < 1
inline void require_valid(const RelaxationSettings& settings) {
  if (settings.steps && *settings.steps < 0)
    refuse("sweeps must not be negative, got ", *settings.steps);
  if (!(settings.tightness >= 0 && settings.tightness < 1))
    refuse("tightness must be in [0, 1), got ", settings.tightness);
}

}  // namespace ffcontact
