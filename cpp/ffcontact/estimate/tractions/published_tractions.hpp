// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/cone_correction.hpp"

namespace ffcontact {

/// Correction (4.1) where it keeps the balance of a triangle. Where the contact tangent
/// is not that of the edge (given directions), a shift d of r_t has the moment d l/6
/// times the edge's part along n: such an edge is listed as uncorrected.
ConeCorrection published_tractions(const Mesh& mesh, const ContactLine& line,
                                   const ContactLaw<2>& law,
                                   const ContactDensities& computed);

}  // namespace ffcontact
