// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/elastic/elastic_system.hpp"

namespace ffcontact {

/// As on a line (line_balance), with the cones a thousandth wider, of 64 sides: what they
/// cannot balance no force in the cones can.
MatrixXd extreme_forces(const ContactSurface& surface, const ContactLaw<3>& law,
                        const MatrixXd& motions);

}  // namespace ffcontact
