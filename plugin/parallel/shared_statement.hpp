// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parallel/shared_contact.hpp"
#include "problem/contact_problem.hpp"

/// Statements of bodies that processes hold parts of.
namespace ffcontact::plugin {

/// The processes of comm=, null where there is one.
/// @throws std::invalid_argument  if the module for them is not loaded
std::shared_ptr<Team> stated_team(Stack stack, const NamedArguments& named);

template <int dim>
struct SharedStatement {
  std::shared_ptr<ContactProblem<dim>> problem;  ///< on process 0
  std::shared_ptr<SharedContact> contact;
};

/// @param meshes  the parts of the bodies on this process
template <int dim>
SharedStatement<dim> state_shared(Stack stack, const NamedArguments& named,
                                  const FemMeshes<dim>& meshes,
                                  const std::shared_ptr<Team>& team);

}  // namespace ffcontact::plugin
