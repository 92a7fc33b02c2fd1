// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Multipliers and displacements of all rows dim i + c [rows].
struct ContactRows {
  VectorXd P, v;
};

}  // namespace ffcontact
