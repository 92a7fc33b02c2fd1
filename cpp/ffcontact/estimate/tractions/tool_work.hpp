// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/law/contact_densities.hpp"
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

/// What contact tractions have to do along the free motions z_k of a tool:
///     int r_hat . z_k = push . z_k.
/// Those of the exact solution do it, too. Its motion z and that found, z_hat, differ by
/// free ones; w = u - z on the contact line, so that the bound (2.20) has the further term
///     2 int (r - r_hat) . (z - z_hat) = 0,
/// and e bounds the error of a problem with a tool as it does that of one without.
struct ToolWork {
  MatrixXd fields;  ///< z_k, of size 1 on the line [2 * vertices x k]
  VectorXd work;    ///< [N/mm times 1]
};

/// Nothing (k = 0) for a body without a tool.
ToolWork tool_work(const Mesh& mesh, const ContactLine& line,
                   const SolvedBody<2>& body);

/// What tractions miss of that work, over the length of the line [MPa].
double tool_defect(const ContactLine& line, const ToolWork& tool,
                   const ContactDensities& densities);

}  // namespace ffcontact
