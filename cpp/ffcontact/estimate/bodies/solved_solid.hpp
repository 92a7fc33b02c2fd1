// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/law/surface_law.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/equilibrium/tractions/face_tractions.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// A computed contact solution of a solid and what it was computed from.
struct SolvedSolid {
  HookeTensors<3> hooke;  ///< per tetrahedron [MPa]
  VectorXd displacement;  ///< u_h on all dofs [mm]
  Matrix3Xd force;        ///< (F_n, F_t1, F_t2) at the contact nodes [N]
  SurfaceLaw law;
  /// moments of the given tractions, as for given_tractions [N, 9 x boundary]
  FaceMoments neumann;
  BodyLoadsOfCells<3> body_loads;  ///< int f phi_i per tetrahedron [N]
  std::shared_ptr<const CondensedStiffness>
      stiffness;  ///< of the solution on the surface; null: factorised if needed
  /// tau0 = sigma0 - C eps0 of sigma = C eps(u) + tau0; empty: none
  LinearStresses<3> initial{};
  /// of which A has the stiffness, and the loads what K u_0 makes of them
  BoundarySprings<3> springs{};
};

/// What an estimate of a solid is asked of.
struct SolvedSolidProblem {
  const Topology<3>& topology;
  const ContactSurface& surface;
  const ElasticSystem& system;
  const SolvedSolid& body;
};

}  // namespace ffcontact
