// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// Two traces in contact, paired along the contact directions n of the first: x faces y =
/// x + s n, s > 0 where they are apart. The traces need not lie on each other (curved
/// bodies, initial gaps), their vertices need not match, and either may go on where the
/// other ends. Ends that all but meet a vertex, within 1e-4 of its edge, are taken for
/// it.
struct FacingTraces {
  std::vector<FacingPiece> pieces;  ///< contact edge by contact edge, ascending
  /// s at each node of the line, infinite where it faces nothing [mm]
  VectorXd gap;
};

/// @param opposite_labels  boundary labels of the opposite body
/// @throws std::invalid_argument  if no point of the line faces an opposite edge
FacingTraces facing_traces(const Mesh& mesh, const Edges& edges,
                           const ContactLine& line,
                           const std::vector<int>& opposite_labels);

/// The part of the line that faces the opposite body, with that body behind it
/// (ContactLine::opposite, opposite_edge, pieces).
///
/// Edges that face nothing are left out, and of an edge that the opposite body ends in
/// only the facing part is a contact edge, so that no traction acts where nothing faces
/// it. On that part psi of the node that it shares with the edge beside it is 1:
/// multipliers go on as constants, as they do at the ends of mortar lines where nodes are
/// prescribed (B. Wohlmuth, SIAM J. Numer. Anal. 38, 2000), for the trace of one edge
/// cannot hold two independent multipliers a small distance apart. Only where the edge
/// beside it does not face more of itself are they linear there, with a node at the end
/// that moves as the edge does.
///
/// Displacements of the opposite trace are projected in L2 of the line's trace onto the
/// space of the psi,
///     sum_k (int psi_i psi_k) (Pi u)_k = int psi_i u_opposite        (sums over nodes on one straight line),
/// and so is what the own trace moves more than its nodes where psi are constant, so that
/// v = M (u - Pi u_opposite) are the exact integrals int psi_i [u] on the common
/// refinement, for any mesh of either body [CHH01, reference 5]. Where traces match Pi
/// picks the facing vertex.
ContactLine facing_line(const Mesh& mesh, const Edges& edges,
                        const ContactLine& line, const FacingTraces& traces);

/// The opposite trace of a facing line as the line, with the same pieces: what faces each
/// other, the gap, u_n, u_t and tractions stay what they are, n turns its sign with the
/// body. Nothing where two parts of the line face one place of the opposite body.
/// @param opposite_labels  those of facing_traces
std::optional<ContactLine> exchanged_line(
    const Mesh& mesh, const Edges& edges, const ContactLine& line,
    const std::vector<int>& opposite_labels);

/// Whether the density is constant on a contact edge, its node that of the whole edge
/// beside it.
bool is_constant_on(const ContactLine& line, int e);

/// Whether a contact edge ends where its node is: not at the far end of one on which the
/// density is constant.
bool ends_at_its_node(const ContactLine& line, int end, int e);

/// Arc length of a place on an edge of a line of whole edges [mm].
double abscissa_at(const ContactLine& line, int e, double place);

/// The gap of the meshes at each node of a facing line, the smallest where pieces meet at
/// a step [mm].
VectorXd facing_gap(const ContactLine& line);

/// Several lines one after the other as one.
ContactLine joined_lines(const std::vector<ContactLine>& lines);

}  // namespace ffcontact
