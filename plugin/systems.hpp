// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "contact_problem.hpp"

/// Matrices and displacements that a script gives of each body.
namespace ffcontact::plugin {

/// @throws std::invalid_argument  if it was never assigned, or is not that of [P1, P1] on
///                                the mesh of the body
RowMatrix matrix_of_body(Stack stack, const ContactProblem& problem, int body,
                         Expression matrix);

/// On all dofs.
/// @throws std::invalid_argument  if one is not that of [P1, P1] on the mesh of its body
VectorXd joined_displacement(const ContactProblem& problem,
                             const std::vector<KN<double>*>& u);

ElasticSystem joined(std::vector<ElasticSystem> systems);

}  // namespace ffcontact::plugin
