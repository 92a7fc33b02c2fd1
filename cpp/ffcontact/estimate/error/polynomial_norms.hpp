// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/estimate/error/stress_norms.hpp"

namespace ffcontact {

/// Of the polynomial construction, its stress by point values.
CellNorms<2> polynomial_norms(const StressPair<2>& pair, int triangle);

}  // namespace ffcontact
