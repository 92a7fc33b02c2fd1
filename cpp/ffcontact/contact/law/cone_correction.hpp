// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"

namespace ffcontact {

/// Cone correction: bring equilibrated contact densities into Coulomb's cone.
///
/// On a straight contact edge with ends i, j the densities r_n (compression < 0) and r_t
/// are linear. For constant mu Coulomb's condition  |r_t| <= c,  c = -mu r_n >= 0,  holds
/// on the whole edge if and only if it holds at both ends. The correction is the smallest
/// shift d, opposite at the two ends, that achieves it [CHH01, (4.1)]:
///     |r_t,i - d| <= c_i,   |r_t,j + d| <= c_j.
/// The added density has no resultant and, being tangential, no moment, so the triangle
/// stays in equilibrium. A shift exists if and only if r_n <= 0 at both ends and |r_t,i +
/// r_t,j| <= c_i + c_j; where mu varies the sum, which no shift changes, must also be at
/// most c_i + c_j of the exchanged mu, mu_j p_i + mu_i p_j: enough for the cone between
/// the ends (b_1 >= 0 of EdgeCone). Otherwise the edge is left alone and listed.
struct ConeCorrection {
  ContactDensities densities;  ///< normal part unchanged
  /// d, one per edge [MPa]; 0 where none is needed or none exists
  VectorXd shift;
  std::vector<int> uncorrected;  ///< edges without a shift, ascending

  int corrected_count() const;
};

/// @throws std::invalid_argument  if sizes differ, a value is not finite, or the given
///                                directions of a line turn along an edge
ConeCorrection correct_to_cone(const ContactLine& line,
                               const ContactLaw<2>& law,
                               const ContactDensities& densities);

}  // namespace ffcontact
