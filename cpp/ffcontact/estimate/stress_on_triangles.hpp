// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/estimate/estimate.hpp"

namespace ffcontact {

/// sigma_hat at the corners of the subtriangles of the computed solution's triangles:
/// estimate.stress, and on a triangle that was cut for a common refinement the values of
/// the cut stress there, as seen from the subtriangle's centroid.
std::vector<SubcellStress<2>> stress_on_triangles(const Mesh& mesh,
                                                  const Estimate<2>& estimate);

}  // namespace ffcontact
