// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/cone_correction.hpp"

namespace ffcontact {

/// Contact tractions in the cone, made from those of the solver.
///
/// 1. Correction (4.1), edge by edge; it changes neither resultant nor moment of an edge (correct_edges_to_cone).
/// 2. Edges that (4.1) cannot mend (lambda_n tensile at an end, as happens with M''_h) get the density in the cone that is
///    nearest to lambda_h in L2 of the edge. That changes the nodal forces, so that stresses have to be rebalanced.
/// 3. Where a rigid motion z of the body is held by contact alone, int z . r must stay as it was: every edge's density is
///    multiplied by its own factor s_e >= 0, the nearest to 1 in least squares that restore these resultants. The cone is kept,
///    being a cone. With Tresca's law the tangential part has a factor of its own, within what its bound leaves.
struct AdmissibleTractions {
  ContactDensities densities;   ///< r_hat
  ContactDensities balanced;    ///< before the shifts of (4.1): what nodal equilibrium is built with
  Eigen::VectorXd shift;        ///< d of (4.1) per edge [MPa]
  std::vector<int> mended;      ///< edges of step 2, ascending
  bool resultants_kept = true;  ///< false when no factors s_e >= 0 restore the resultants

  int corrected_count() const { return static_cast<int>((shift.array() != 0).count()); }
};

/// @param motions  rigid motions that no prescribed dof stops [2 * vertices x k]
AdmissibleTractions admissible_tractions(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                                         const ContactDensities& computed, const Eigen::MatrixXd& motions);

/// Correction (4.1) where it keeps the balance of a triangle. Where the contact tangent is not that of the edge (given
/// directions), a shift d of r_t has the moment d l/6 times the edge's part along n: such an edge is listed as uncorrected.
ConeCorrection correct_edges_to_cone(const Mesh& mesh, const ContactLine& line, const ContactLaw& law,
                                     const ContactDensities& computed);

/// The density in the cone that is nearest to the given one in L2 of one edge.
/// @param density  (r_n, r_t) at the two ends, one column each [MPa]
Eigen::Matrix2d nearest_in_cone(const ContactLaw& law, int first_node, int second_node, const Eigen::Matrix2d& density);

/// Forces int r phi on all dofs [N/mm].
Eigen::VectorXd nodal_forces(const Mesh& mesh, const ContactLine& line, const ContactDensities& densities);

}  // namespace ffcontact
