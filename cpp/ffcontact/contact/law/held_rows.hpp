// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// 1 for the rows 2 i + c (0 normal, 1 tangential) whose direction moves no free dof, on
/// either body: a force there loads none [2 p].
///
/// What the trace of the opposite body takes from vertices that weigh less than 1e-3 does
/// not count: where prescribed vertices all but face prescribed ones, as in meshes that
/// were written with a few digits, a force would have to be as many times larger than
/// all others to act through it.
Flags held_rows(const ContactLine& line, const Flags& prescribed);

/// Held rows and what prescribed values make of them.
template <int d>
struct HeldRows {
  Flags
      row;  ///< of a line held_rows, of a surface those of surface_trace [d p]
  /// (u_n - gap, u_t - previous) of the prescribed values there [d x p]; of a line 0 where the
  /// vertices that do not count, or 1e-6 of the largest of these, could make it so, of a
  /// surface 0
  Matrix<double, d, Dynamic> v;
};
HeldRows<2> held_rows(const ContactLine& line, const ContactLaw<2>& law,
                      const ElasticSystem& system);

/// (u_n - gap, u_t - previous) at the nodes, on held rows that of the prescribed values
/// [d x p].
template <int d>
Matrix<double, d, Dynamic> steered_displacement(
    const LineOrSurface<d>& where, const ContactLaw<d>& law,
    const HeldRows<d>& held, const Ref<const VectorXd>& displacement) {
  Matrix<double, d, Dynamic> v =
      displacement_against_foundation(where, law, displacement);
  for (Index row = 0; row < v.size(); ++row)
    if (held.row[row]) v.data()[row] = held.v.data()[row];
  return v;
}

}  // namespace ffcontact
