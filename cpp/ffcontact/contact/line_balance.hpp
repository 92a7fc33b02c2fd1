// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// require_balance of balance.hpp for a contact line. Coulomb's law at a node spans
/// -n + mu t and -n - mu t; with Tresca's law the bounded tangential forces are taken at
/// their largest in either direction.
/// @throws NoEquilibrium  naming the motion that nothing opposes
void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw& law, const ElasticSystem& system);

/// Can contact balance the loads of the body and those on a rigid foundation that forces
/// move?
/// @param motions  of the foundation, as fields on all dofs, one a column
/// @param push     force or moment along each of them, which contact passes on to the body
/// @throws std::invalid_argument  if it cannot
void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw& law, const ElasticSystem& system,
                     const MatrixXd& motions, const VectorXd& push);

}  // namespace ffcontact
