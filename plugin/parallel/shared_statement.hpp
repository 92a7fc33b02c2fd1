// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "parallel/shared_contact.hpp"
#include "problem/contact_problem.hpp"
#include "problem/solid_problem.hpp"

/// Statements of bodies that processes hold parts of.
namespace ffcontact::plugin {

/// The processes of comm=, null where there is one.
/// @throws std::invalid_argument  if the module for them is not loaded
std::shared_ptr<Team> stated_team(Stack stack, const NamedArguments& named);

template <int dim>
using ProblemOf = std::conditional_t<dim == 2, ContactProblem, SolidProblem>;

template <int dim>
struct SharedStatement {
  std::shared_ptr<ProblemOf<dim>> problem;  ///< on process 0
  std::shared_ptr<SharedContact> contact;
};

/// @param meshes  the parts of the bodies on this process
template <int dim>
SharedStatement<dim> state_shared(Stack stack, const NamedArguments& named,
                                  const FemMeshes<dim>& meshes,
                                  const std::shared_ptr<Team>& team);

}  // namespace ffcontact::plugin
