// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/estimate/estimate.hpp"
//
#include "problem/contact_problem.hpp"
#include "problem/nodal_results.hpp"

namespace ffcontact::plugin {

/// A solution with the system it belongs to.
struct SolvedSolid {
  std::shared_ptr<const ElasticSystem> system;
  ContactLaw<3> law;  ///< with u_t of the load step before
  ContactSolution<3> solution;
  BodyLoadsOfCells<3> holding;  ///< that of HeldSliding, which the system has
  SolidResults nodes;
  /// what contacterror made of it last, and of what; null before
  std::shared_ptr<const Estimate<3>> estimate;
  std::shared_ptr<const SolvedBody<3>> judged;
};

/// What nodes have done and where they are, in vectors along x, y, z [3 x p].
struct PlacedAnswer {
  ContactStates state;
  Matrix3Xd place, normal;
  Matrix3Xd pressure;      ///< [MPa]
  Matrix3Xd moved;         ///< against the foundation or the other body [mm]
  std::vector<long> side;  ///< of each pair that these are those of
};

/// The contact of solids, as a variable of the script holds it.
struct SolidContact {
  std::shared_ptr<ContactProblem<3>> problem;  ///< null until it is stated
  std::optional<SolvedSolid> solved;
  PlacedAnswer last;  ///< of the last solution: the next one starts from them
};

}  // namespace ffcontact::plugin
