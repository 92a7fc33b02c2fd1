// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "ffcontact/contact/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// Can contact balance the loads on the rigid motions z that no prescribed dof stops?
///
/// It can when nodal forces in the cone exist with z . (b + forces) = 0 for all z. The cone of Coulomb's law at a node is
/// spanned by -n + mu t and -n - mu t, so this is a nonnegative least-squares problem with one row per motion; what it leaves
/// over is (Farkas) a motion that the loads push and no admissible force opposes. With Tresca's law the bounded tangential
/// forces are taken at their largest in either direction.
/// @throws std::invalid_argument  naming that motion
void require_balance(const Mesh& mesh, const ContactLine& line, const ContactLaw& law, const ElasticSystem& system);

}  // namespace ffcontact
