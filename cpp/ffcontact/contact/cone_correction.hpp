// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/contact_law.hpp"

namespace ffcontact {

/// Contact tractions that are linear on each contact edge, by their values at its first and second node. They may jump from
/// edge to edge.
struct ContactDensities {
  Eigen::Matrix2Xd normal;      ///< r_n at the two ends of each edge [MPa], compression < 0 [2 x m]
  Eigen::Matrix2Xd tangential;  ///< r_t likewise
};

/// The continuous densities with the given nodal values (lambda_n, lambda_t) [2 x p].
ContactDensities edge_densities(const ContactLine& line, const Eigen::Ref<const Eigen::Matrix2Xd>& pressure);

/// Largest tangential traction the law allows at the two ends of each edge, for given normal densities [MPa, 2 x m]:
/// c = -mu r_n (Coulomb, negative where r_n is tensile) or the slip bound (Tresca).
Eigen::Matrix2Xd slip_limits(const ContactLine& line, const ContactLaw& law, const Eigen::Matrix2Xd& normal);

/// Cone correction: bring equilibrated contact densities into Coulomb's cone.
///
/// On a straight contact edge with ends i, j the densities r_n (compression < 0) and r_t are linear. For constant mu Coulomb's
/// condition  |r_t| <= c,  c = -mu r_n >= 0,  holds on the whole edge if and only if it holds at both ends. The correction is
/// the smallest shift d, opposite at the two ends, that achieves it [CHH01, (4.1)]:
///     |r_t,i - d| <= c_i,   |r_t,j + d| <= c_j.
/// The added density has no resultant and, being tangential, no moment, so the triangle stays in equilibrium. A shift exists
/// if and only if r_n <= 0 at both ends and |r_t,i + r_t,j| <= c_i + c_j; otherwise the edge is left alone and listed.
struct ConeCorrection {
  ContactDensities densities;    ///< normal part unchanged
  Eigen::VectorXd shift;         ///< d, one per edge [MPa]; 0 where none is needed or none exists
  std::vector<int> uncorrected;  ///< edges without a shift, ascending

  int corrected_count() const { return static_cast<int>((shift.array() != 0).count()); }
};

/// @throws std::invalid_argument  if sizes differ, a value is not finite, or the given directions of a line turn along an edge
ConeCorrection correct_to_cone(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities);

/// Largest of r_n and |r_t| - c over all edge ends, relative to the largest traction; 0 inside the cone.
double cone_defect(const ContactLine& line, const ContactLaw& law, const ContactDensities& densities);

}  // namespace ffcontact
