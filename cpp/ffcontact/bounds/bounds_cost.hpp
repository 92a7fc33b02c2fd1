// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ffcontact {

/// What bounds take beside the estimate that they start from.
struct BoundsCost {
  int contact_problems = 0;  ///< with one factor
  int estimates = 0;
};

}  // namespace ffcontact
