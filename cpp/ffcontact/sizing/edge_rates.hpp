// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// A line of boundary edges of a solid about which the stress may be singular, and how
/// strongly; as SingularVertex in the plane.
///
/// Its edges are such that the boundary turns by more than 30 degrees there, or that the
/// boundary condition changes: other components known, contact or not. They go on from
/// one to the next at a vertex that has two of them, which turn by less than 30 degrees.
///
/// The energy within r of the middle half of the line is W(r) ~ r^(2 alpha); a bounded
/// stress has alpha = 1. alpha is fitted from the computed stresses between 1.5 and 8
/// element sizes, at most a quarter of the line's length and half the way from its middle
/// half to the next line that does not touch it.
struct SingularLine {
  std::vector<int> edges;
  /// alpha, in (0, 1]; 1 where the stress is bounded or too few elements allow a fit
  double exponent;
};

/// @param stress      sigma_h per tetrahedron [MPa]
/// @param known       components of the traction that are given [3 x faces]
/// @param is_contact  1 for contact faces [faces]
std::vector<SingularLine> singular_lines(
    const Topology<3>& topology, const HookeTensors<3>& hooke,
    const Ref<const CellStresses<3>>& stress, const KnownComponents& known,
    const Flags& is_contact);

/// Local rates q_E of the error, eps_E ~ h_E^q_E: alpha on the tetrahedra at a singular
/// line, 1 on all others.
VectorXd local_rates(const Topology<3>& topology,
                     const std::vector<SingularLine>& singular);

}  // namespace ffcontact
