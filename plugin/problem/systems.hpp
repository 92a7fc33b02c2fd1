// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/elastic_system.hpp"
#include "freefem/arguments.hpp"
#include "problem/contact_problem.hpp"

/// Matrices, displacements and pressures that a script gives.
namespace ffcontact::plugin {

/// @param mesh  of all bodies
/// @throws std::invalid_argument  if it was never assigned, or has not the dofs of the body
///                                in the order of its vertices
template <int d>
RowMatrix matrix_of_body(Stack stack, const BodyDofs& bodies, int body,
                         Expression matrix, const SimplexMesh<d>& mesh);

/// On all dofs.
/// @throws std::invalid_argument  if one has not the dofs of its body
VectorXd joined_displacement(const BodyDofs& bodies,
                             const std::vector<KN<double>*>& u);

ElasticSystem joined(std::vector<ElasticSystem> systems);

/// Reads multiplier=: what pn and pt stand for.
/// @throws std::invalid_argument  if it is neither "force" nor "pressure"
Multiplier multiplier_of(Stack stack, const NamedArguments& named);

/// Nodal pressures from the script's pn and pt [2 x p].
Matrix2Xd pressures_of(const ContactProblem<2>& problem, KN<double>* normal,
                       KN<double>* tangential);

}  // namespace ffcontact::plugin
