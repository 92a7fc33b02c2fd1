// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// A line of pieces with the body behind them (ContactLine::opposite, opposite_edge).
///
/// Displacements of the opposite trace are projected in L2 of the line's trace onto the
/// space of the psi,
///     sum_k (int psi_i psi_k) (Pi u)_k = int psi_i u_opposite        (sums over nodes on one straight line),
/// and so is what the own trace moves more than its nodes where psi are constant, so that
/// v = M (u - Pi u_opposite) are the exact integrals int psi_i [u] on the common
/// refinement, for any mesh of either body [CHH01, reference 5]. Where traces match Pi
/// picks the facing vertex.
ContactLine with_opposite(const Mesh& mesh, const Edges& edges,
                          ContactLine line);

}  // namespace ffcontact
