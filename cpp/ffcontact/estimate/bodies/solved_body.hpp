// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/contact/rigid_tool.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

namespace ffcontact {

/// A computed contact solution and what it was computed from.
struct SolvedBody {
  Hooke hooke;            ///< per triangle [MPa]
  VectorXd displacement;  ///< u_h on all dofs [mm]
  Matrix2Xd pressure;     ///< (lambda_n, lambda_t) at the contact nodes [MPa]
  ContactLaw law;
  /// moments of the given tractions, as for boundary_tractions [4 x Mesh::boundary]
  Matrix4Xd neumann;
  BodyLoadsOfCells<2>
      body_loads;  ///< int f phi_i per triangle [N/mm, 6 x triangles]
  std::shared_ptr<const CondensedStiffness>
      stiffness;  ///< of the solution on the contact line; null: factorised if needed
  /// tau0 = sigma0 - C eps0 of sigma = C eps(u) + tau0; empty: none
  LinearStresses<2> initial{};
  /// of which A has the stiffness, and the loads what K u_0 makes of them
  BoundarySprings<2> springs{};
  /// the foundation, if forces move it: the law is against where they have moved it, and
  /// what pushes it is a part of the data
  std::optional<RigidTool> tool{};
};

}  // namespace ffcontact
