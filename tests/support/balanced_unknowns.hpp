// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/equilibrium/energy/facet_forms.hpp"
#include "ffcontact/mesh/topology.hpp"
#include "support/random.hpp"

/// Wrenches and modes on the faces of one tetrahedron.
namespace ffcontact::test {

/// Unknowns of a tetrahedron's faces that balance on it: any wrenches and modes on three of
/// its faces, and what they ask of a fourth one.
inline CellVector<3> balanced_unknowns(const Topology<3>& topology, int cell,
                                       int d, std::mt19937& random) {
  CellVector<3> x = random_vector(36, random);
  x.segment<6>(9 * d).setZero();
  for (int k = 0; k < 4; ++k)
    if (k != d)
      x.segment<6>(9 * d) +=
          balancing_shift<3>(topology, cell, k, d).times(x.segment<6>(9 * k));
  return x;
}

}  // namespace ffcontact::test
