// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// P and v of all rows near those of the law, for surface_newton to start from: its steps
/// are few then, whatever the number of nodes, and those on which it finds this are small.
///
/// Nodes are gathered in aggregates of some seven that share faces, which move by a
/// smoothed prolongation [Vanek, Mandel, Brezina 1996],
///     u = R u_a,   R = diag(M 1)^-1 M R_0,
/// with the mass M and R_0 = 1 from an aggregate to its nodes, directions from the frame of
/// its first one to theirs. Their forces F_a = R' P and v = R u_a make
///     F_a = R' S R u_a - R' g,
/// a relation like the nodes' own, under the law with the cones of the means. Back on the
/// nodes tractions are R F_a / A_a and displacements R u_a.
///
/// Rows that are held or dependent are left out.
/// @return nothing where the law of the aggregates is not solved
std::optional<ContactRows> coarse_start(const CondensedContact& contact,
                                        const NodalLaw& law,
                                        const ContactSurface& surface);

}  // namespace ffcontact
