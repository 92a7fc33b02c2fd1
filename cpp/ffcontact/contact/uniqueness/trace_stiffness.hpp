// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"

namespace ffcontact {

/// The condensed relation for all rows that may move independently, P = S v with loads
/// apart: the primary ones, and of the dependent ones those that opposite vertices move
/// (the last node of a line on a symmetry axis that the other body's does not share).
/// With v_d = E' v + F q of these,
///     q = F^-1 (v_d - E' v),   P = S v - E q.
struct TraceStiffness {
  MatrixXd S;            ///< [k x k]
  VectorXi place;        ///< of each row 2 i + c in it, or -1 [2 p]
  std::vector<int> row;  ///< of each unknown [k]
  /// does the v of a row that is not held follow from the v of this unknown? [k]
  Flags is_followed;
};
TraceStiffness trace_stiffness(const CondensedContact& contact);

}  // namespace ffcontact
