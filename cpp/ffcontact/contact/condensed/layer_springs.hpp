// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/condensed/contact_trace.hpp"

namespace ffcontact {

/// Adds a compliant layer to what moves the rows: each row that it is on gets a component w_l
/// of the other side,
///     v = A w + w_l,   w_l / c = P,
/// so that the relation between P and v has the layer in series with the bodies.
/// @param compliance  nodal_compliance [rows]
void add_layer(const VectorXd& compliance, ContactTrace& trace);

}  // namespace ffcontact
