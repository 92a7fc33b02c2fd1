// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/condensed/contact_trace.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// Motions of a rigid foundation that forces move: they are opposite components without
/// stiffness, v = W (trace of u - trace z), which
///     (W trace)' P = load
/// holds.
struct FoundationMotions {
  MatrixXd
      trace;  ///< (n . z, t . z) at the nodes, one motion a column [2 p x m]
  VectorXd load;  ///< what contact does to the body along each of them [m]
};

/// Adds them to what moves the rows of a contact line.
/// @param held  rows that no displacement moves [2 p]
/// @param W     weight_of_rows
void add_motions(const FoundationMotions& foundation, const ContactLaw<2>& law,
                 const Flags& held, const SparseMatrix& W, ContactTrace& trace);

}  // namespace ffcontact
