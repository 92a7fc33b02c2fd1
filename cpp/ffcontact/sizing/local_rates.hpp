// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// A boundary vertex about which the stress may be singular, and how strongly.
///
/// The energy in discs about it is W(r) ~ r^(2 alpha); a bounded stress has alpha = 1.
/// The exponent is the slope of log W against log r, fitted from the computed stresses
/// between two and eight element sizes, and at most half the way to the next such vertex.
struct SingularVertex {
  int vertex;
  /// alpha, in (0, 1]; 1 where the stress is bounded or too few elements allow a fit
  double exponent;
};

/// Vertices where the boundary turns by more than a degree, or where the boundary
/// condition changes: other components known, contact or not.
/// @param stress      sigma_h per triangle [MPa]
/// @param compliance  C^-1 per triangle through `hooke`
std::vector<SingularVertex> singular_vertices(
    const Topology<2>& topology, const Hooke& hooke,
    const Ref<const Matrix3Xd>& stress, const BoundaryTractions& boundary,
    const std::vector<int>& contact_edges);

/// Local rates q_E of the error, eps_E ~ h_E^q_E: alpha on the triangles at a singular
/// vertex, where the singularity sets the error, 1 on all others [P. Coorevits, P.
/// Ladeveze, J.-P. Pelle, Engrg. Comput. 11 (1994); CHH01, 5.1].
VectorXd local_rates(const Topology<2>& topology,
                     const std::vector<SingularVertex>& singular);

}  // namespace ffcontact
