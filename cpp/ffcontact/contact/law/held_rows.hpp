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
struct HeldRows {
  Flags row;  ///< held_rows
  /// (u_n - gap, u_t - previous) of the prescribed values there [2 x p]; 0 where the
  /// vertices that do not count, or 1e-6 of the largest of these, could make it so
  Matrix2Xd v;
};
HeldRows held_rows(const ContactLine& line, const ContactLaw& law,
                   const ElasticSystem& system);

/// (u_n - gap, u_t - previous) at the nodes, on held rows that of the prescribed values
/// [2 x p].
Matrix2Xd steered_displacement(const ContactLine& line, const ContactLaw& law,
                               const HeldRows& held,
                               const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
