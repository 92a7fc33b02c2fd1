// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_densities.hpp"

namespace ffcontact {

/// Forces int r phi of contact tractions on all dofs [N/mm]: r on the line's body, -r on
/// the opposite one.
VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line,
                      const ContactDensities& densities);

}  // namespace ffcontact
