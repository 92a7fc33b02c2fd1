// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/rigid_tool.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "ffcontact/interface/nearest_nodes.hpp"
//
#include "problem/contact_problem.hpp"
#include "problem/nodal_results.hpp"
#include "problem/result_names.hpp"

namespace ffcontact::plugin {

/// A rigid foundation that a solution has moved.
struct MovedTool {
  RigidTool tool;   ///< as it was pushed
  VectorXd motion;  ///< (x, y, turn)
  VectorXd slid;    ///< t . its motion at the nodes [mm]
};

/// A solution with the system it belongs to.
template <int d>
struct SolvedContact {
  std::shared_ptr<const ElasticSystem> system;
  ContactLaw<d> law;  ///< with the multiplier, and u_t of the load step before
  ContactSolution<d> solution;
  std::optional<MovedTool> moved{};
  BodyLoadsOfCells<d> holding;  ///< that of HeldSliding, which the system has
  NodalResults nodes;
  /// what contacterror made of it last; null before
  std::shared_ptr<const Estimate<d>> estimate;
  std::shared_ptr<const SolvedBody<d>> judged;  ///< and of what; of solids
};

/// What nodes have done and where they were, in vectors along x, y (z) on the body that comes
/// first [d x p].
struct LastNodes {
  ContactStates state;  ///< empty: nothing was solved
  PlacedNodes at;
  MatrixXd pressure;  ///< [MPa]
  MatrixXd moved;     ///< against the foundation or the other body [mm]
};

/// A contact of bodies in d dimensions.
template <int d>
struct ContactOf {
  std::shared_ptr<ContactProblem<d>> problem;  ///< null until it is stated
  std::optional<SolvedContact<d>> solved;
  LastNodes last;  ///< of the last solution: the next one starts from them

  /// A new problem: the last nodes stay.
  void state(std::shared_ptr<ContactProblem<d>> stated) {
    problem = std::move(stated);
    solved.reset();
  }
};

struct SharedContact;

/// What a script variable of type `contact` holds: a contact of plane bodies, or of
/// solids.
struct Contact : ContactOf<2> {
  std::shared_ptr<ContactOf<3>> solid;  ///< null where it is not of solids
  /// where processes hold parts of the bodies; null: one holds them
  std::shared_ptr<SharedContact> shared;
};

template <int d>
ContactOf<d>& contact_in(Contact& contact) {
  if constexpr (d == 2)
    return contact;
  else
    return *contact.solid;
}

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

/// The solution of a contact.
/// @throws std::invalid_argument  if it was not solved
template <int d>
const SolvedContact<d>& solved_contact(const ContactOf<d>& contact) {
  if (!contact.solved) refuse_unsolved();
  return *contact.solved;
}

/// @throws std::invalid_argument  if the contact is that of a solid
const ContactProblem<2>& plane_problem(const Contact& contact);
/// @throws std::invalid_argument  if the contact was never stated
void require_stated(const Contact& contact);

}  // namespace ffcontact::plugin
