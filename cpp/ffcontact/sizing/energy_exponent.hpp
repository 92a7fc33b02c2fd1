// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace ffcontact {

/// The energy of a cell and how far it is from a vertex or an edge.
struct EnergyAtDistance {
  double distance, energy;
};
using Neighbourhood = std::vector<EnergyAtDistance>;

/// alpha of W(r) ~ r^(2 alpha), the energy within r: half the slope of the line nearest to
/// log W against log r over radii of which each is 1.25 times the one before; in [0.1, 1],
/// and 1 where there are less than four.
double fitted_exponent(const Neighbourhood& near, double smallest,
                       double largest);

}  // namespace ffcontact
