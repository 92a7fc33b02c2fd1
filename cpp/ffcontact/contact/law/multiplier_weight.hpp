// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The two discrete convexes of multipliers [CHH01, 3.1]. In both the conditions hold
/// node by node between a multiplier P and a displacement W u, and the body is loaded by
/// W P:
enum class Multiplier {
  pressure,  ///< M'_h (Prop. 3.4): W = M, P = nodal pressures L [MPa]
  force,     ///< M''_h (Prop. 3.5): W = I, P = nodal forces F = M L [N/mm]
};

/// W of the law on a line: the mass matrix (3.9) or the identity [p x p].
SparseMatrix weight_matrix(Multiplier multiplier, const ContactLine& line);

/// W for both components, row 2 i + c, so that the forces are W P and v = W (components
/// of a displacement) [2 p x 2 p]. Where neighbours i, j have different normals the
/// vectors are weighted, not the components: block (i, j) is w_ij times the rotation from
/// the frame of j to that of i, and W P is exactly the load of the vector density with
/// nodal values P.
SparseMatrix weight_of_rows(Multiplier multiplier, const ContactLine& line);

}  // namespace ffcontact
