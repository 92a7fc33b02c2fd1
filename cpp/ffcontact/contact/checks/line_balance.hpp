// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// Work along each motion of multipliers that span the cones, one column per multiplier
/// [motions x multipliers]. Coulomb's law at a node spans -n + mu t and -n - mu t, here of
/// size 1 whatever mu is, and -n is one of them: of two that are nearly +t and -t it would
/// be the rounding. With Tresca's law the bounded tangential forces are taken at their
/// largest in either direction. A bonded node has forces of any direction.
MatrixXd extreme_forces(const ContactLine& line, const ContactLaw<2>& law,
                        const MatrixXd& motions);

/// Can contact balance the loads of the body and those on a rigid foundation that forces
/// move?
/// @param motions  of the foundation, as fields on all dofs, one a column
/// @param push     force or moment along each of them, which contact passes on to the body
/// @throws std::invalid_argument  if it cannot
void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw<2>& law, const ElasticSystem& system,
                     const MatrixXd& motions, const VectorXd& push);

}  // namespace ffcontact
