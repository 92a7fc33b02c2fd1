// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/estimate/estimate.hpp"
//
#include "problem/contact_problem.hpp"
#include "problem/nodal_results.hpp"

namespace ffcontact::plugin {

/// A solution with the system it belongs to.
struct SolvedContact {
  std::shared_ptr<const ElasticSystem> system;
  ContactLaw<2> law;  ///< with the multiplier, and u_t of the load step before
  ContactSolution<2> solution;
  /// of a tool: its motion (x, y, turn), and t . z at the nodes [mm]; empty: none
  VectorXd motion, tool;
  std::optional<RigidTool> driven{};  ///< it, as it was pushed
  BodyLoadsOfCells<2> holding;  ///< that of HeldSliding, which the system has
  NodalResults nodes;
  /// what contacterror made of it last; null before
  std::shared_ptr<const Estimate<2>> estimate;
};

struct SharedContact;
struct SolidContact;

/// What a script variable of type `contact` holds: a contact of plane bodies, or of a
/// solid.
struct Contact {
  std::shared_ptr<ContactProblem<2>> problem;  ///< null until it is stated
  std::optional<SolvedContact> solved;
  /// of the last solution: the next one starts from them
  ContactStates last_states;
  VectorXd last_abscissa;               ///< where they were
  std::shared_ptr<SolidContact> solid;  ///< null where it is not of solids
  /// where processes hold parts of the bodies; null: one holds them
  std::shared_ptr<SharedContact> shared;
};

/// The script variable: FreeFEM gives it memory, calls init() and destroy(). It is a
/// number and no pointer, because a parameter that is no reference, f(contact C), is a
/// copy of these bytes and is destroyed when f returns.
struct ContactVariable {
  long number;

  void init();
  void destroy() const;
};

/// @throws std::invalid_argument  if the contact is gone
Contact& contact_of(const ContactVariable& variable);

/// The contact that an argument of a script function names.
/// @throws std::invalid_argument  if it was never stated
Contact& contact_of_processes(Stack stack, Expression variable);

/// The same that one process holds.
/// @throws std::invalid_argument  if it was never stated, or several share it
Contact& stated_contact_of_any(Stack stack, Expression variable);

/// The same of plane bodies.
/// @throws std::invalid_argument  if it was never stated, or is that of a solid
Contact& stated_contact(Stack stack, Expression variable);

/// The solution of that contact.
/// @throws std::invalid_argument  if it was not solved
const SolvedContact& solved_contact(const Contact& contact);

/// @throws std::invalid_argument  if the contact is that of a solid
const ContactProblem<2>& plane_problem(const Contact& contact);
/// @throws std::invalid_argument  if the contact was never stated
void require_stated(const Contact& contact);

}  // namespace ffcontact::plugin
