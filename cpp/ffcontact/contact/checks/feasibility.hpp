// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// Can the line keep clear of what it faces, whatever the prescribed dofs do?
///
/// With c = u_n - gap of the prescribed values alone and the normal components G of the
/// free dofs (those of opposite bodies included) the question is whether w exists with
///     G w + c <= 0
/// at every node, or at every node of the common refinement of traces that do not match.
/// It does not (Farkas) when weights y >= 0 exist with G' y = 0 and y . c > 0: places
/// that prescribed dofs hold in penetration. A solution w above 1000 max c counts as
/// none: to leave the foundation a node would slide along it.
///
/// The question is the same for both multipliers. M'_h asks for M (u_n - gap) <= 0 only,
/// which is met by lifting the neighbours of such a node; but then there is no admissible
/// displacement.
///
/// Where the line is bonded [u] must be 0 in place of this, at each of these places and
/// along each axis: it cannot where dofs that are all prescribed differ.
/// @throws std::invalid_argument  naming the place, how far it is inside, and what to
///                                change
void require_feasible(const Mesh& mesh, const ContactLine& line,
                      const ContactLaw<2>& law, const ElasticSystem& system);

}  // namespace ffcontact
