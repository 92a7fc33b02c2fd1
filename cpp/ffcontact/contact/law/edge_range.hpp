// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Two functions that are linear on each contact edge and enclose a coefficient there, by
/// their values at its ends [2 x m].
struct EdgeRange {
  Matrix2Xd least, most;
};

/// The two lines nearest to the chord that enclose a coefficient >= 0 sampled at evenly
/// spaced points of each edge, ends included: the chord shifted by the largest deviation
/// to either side, or the constant least value where the lower one would fall below 0.
/// Where the samples are on the chord to rounding it is both.
/// @param samples  one column per edge [at least 2 x m]
EdgeRange enclosing_range(const Ref<const MatrixXd>& samples);

/// @throws std::invalid_argument  if it is given and not of so many edges, or a value is
///                                negative or not finite
void require_valid(const char* name, const EdgeRange& range, int edges);

}  // namespace ffcontact
