// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/cone_correction.hpp"

namespace ffcontact {

/// Contact tractions in the cone, made from those of the solver.
///
/// 1. Correction (4.1), edge by edge; it changes neither resultant nor moment of an edge
///    (correct_edges_to_cone).
/// 2. Where it leaves edges outside (lambda_n tensile at an end, as happens with M''_h),
///    r_hat is linear between the nodal pressures
///    p_i = F_i / len_i on the whole line: the forces obey the law, so that p is in the cone, and has their resultant. Where the
///    law varies between the nodes, the density in the cone nearest to it is taken.
/// 3. Where rigid motions z of the body are held by contact alone, int z . r must be what
///    balances the loads: of the tractions in
///    the cone with these resultants the nearest ones to p are taken (nearest_in_cone), or to those of step 1 where lambda_h has
///    other resultants, as on a refinement whose facing edges are not of one length.
/// Steps 2 and 3 change the nodal forces, so that stresses have to be rebalanced.
struct AdmissibleTractions {
  ContactDensities densities;  ///< r_hat
  /// before the shifts of (4.1): what nodal equilibrium is built with
  ContactDensities balanced;
  VectorXd shift;           ///< d of (4.1) per edge [MPa]
  std::vector<int> mended;  ///< edges of steps 2 and 3, ascending: none or all

  int corrected_count() const { return static_cast<int>((shift.array() != 0).count()); }
};

/// @param computed    lambda_h
/// @param pressure    p at the nodes [2 x p]
/// @param motions     rigid motions that no prescribed dof stops [2 * vertices x k]
/// @param resultants  work of the contact forces along them [k]
/// @return nothing if no tractions in the cone have these resultants, as where a body
///         stands on one end of the line
std::optional<AdmissibleTractions> admissible_tractions(
    const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
    const ContactDensities& computed, const Matrix2Xd& pressure, const MatrixXd& motions,
    const VectorXd& resultants);

/// Correction (4.1) where it keeps the balance of a triangle. Where the contact tangent
/// is not that of the edge (given directions), a shift d of r_t has the moment d l/6
/// times the edge's part along n: such an edge is listed as uncorrected.
ConeCorrection correct_edges_to_cone(const Mesh& mesh, const ContactLine& line,
                                     const ContactLaw& law,
                                     const ContactDensities& computed);

/// Forces int r phi on all dofs [N/mm].
VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line,
                      const ContactDensities& densities);

}  // namespace ffcontact
