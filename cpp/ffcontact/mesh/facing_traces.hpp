// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/contact_line.hpp"

namespace ffcontact {

/// Two traces in contact, paired along the contact directions n of the first: x faces y = x + s n, s > 0 where they are apart.
/// The traces need not lie on each other (curved bodies, initial gaps) and their vertices need not match.
struct FacingTraces {
  std::vector<FacingPiece> pieces;  ///< contact edge by contact edge, each from 0 to 1 without holes
  Eigen::VectorXd gap;              ///< s at each node of the line [mm]
};

/// @param line             of the body that carries the multipliers
/// @param opposite_labels  boundary labels of the opposite body
/// @throws std::invalid_argument  if a point of the line faces no opposite edge, naming the point
FacingTraces facing_traces(const Mesh& mesh, const Edges& edges, const ContactLine& line,
                           const std::vector<int>& opposite_labels);

/// The line with the opposite body behind it (ContactLine::opposite, opposite_edge, pieces): displacements of the opposite
/// trace are projected in L2 of the line's trace onto its continuous linear functions,
///     sum_k (int psi_i psi_k) (Pi u)_k = int psi_i u_opposite        (sums over nodes on one straight line),
/// so that v = M (u - Pi u_opposite) are the exact integrals int psi_i [u] on the common refinement, for any mesh of either
/// body [CHH01, reference 5]. Where traces match Pi picks the facing vertex.
ContactLine facing_line(const Mesh& mesh, const Edges& edges, ContactLine line, const FacingTraces& traces);

/// Several lines one after the other as one.
ContactLine joined_lines(const std::vector<ContactLine>& lines);

}  // namespace ffcontact
