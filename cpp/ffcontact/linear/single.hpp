// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

// Eigen's types in single precision by their own names.
using Eigen::MatrixXf;
using Eigen::VectorXf;

}  // namespace ffcontact
