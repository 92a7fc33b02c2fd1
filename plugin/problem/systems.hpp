// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"
#include "freefem/arguments.hpp"
#include "problem/body_dofs.hpp"

/// Matrices and displacements that a script gives of each body.
namespace ffcontact::plugin {

/// @throws std::invalid_argument  if it was never assigned, or has not the dofs of the body
RowMatrix matrix_of_body(Stack stack, const BodyDofs& bodies, int body,
                         Expression matrix);

/// On all dofs.
/// @throws std::invalid_argument  if one has not the dofs of its body
VectorXd joined_displacement(const BodyDofs& bodies,
                             const std::vector<KN<double>*>& u);

ElasticSystem joined(std::vector<ElasticSystem> systems);

}  // namespace ffcontact::plugin
