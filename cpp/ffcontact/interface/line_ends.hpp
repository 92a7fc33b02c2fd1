// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/interface/contact_line.hpp"

/// Contact edges that end between two vertices, as those of facing_line may.
namespace ffcontact {

/// Whether the density is constant on a contact edge, its node that of the whole edge
/// beside it.
bool is_constant_on(const ContactLine& line, int e);

/// Whether a contact edge ends where its node is: not at the far end of one on which the
/// density is constant.
bool ends_at_its_node(const ContactLine& line, int end, int e);

/// The gap of the meshes at each node of a facing line, the smallest where pieces meet at
/// a step [mm]; infinite at a node that faces nothing.
VectorXd facing_gap(const ContactLine& line);

/// Arc length of a place on an edge of a line of whole edges [mm].
double abscissa_at(const ContactLine& line, int e, double place);

}  // namespace ffcontact
