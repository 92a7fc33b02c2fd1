// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/free_tractions.hpp"
#include "ffcontact/equilibrium/star_energy.hpp"

namespace ffcontact {

/// Relaxes the stars of a contact vertex and of those that contact edges join to it
/// across bodies together.
///
/// min y'Hy + 2 g'y + contact cost over the corrections y of the stars that leave known
/// boundary tractions alone and load both bodies of a contact edge oppositely, with r_hat
/// in the cone at the ends of free contact edges.
/// @param airy     unknowns of AirySpace, changed in place
/// @param contact  r_hat, relaxed in place
/// @return by how much e^2 fell
double relax_boundary(const StarSetting& setting,
                      const std::vector<int>& vertices, VectorXd& airy,
                      FreeContact& contact);

}  // namespace ffcontact
