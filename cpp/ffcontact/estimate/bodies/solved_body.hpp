// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "ffcontact/contact/law/contact_law.hpp"
#include "ffcontact/contact/rigid_tool.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"
#include "ffcontact/interface/line_or_surface.hpp"
#include "ffcontact/mesh/topology.hpp"

namespace ffcontact {

/// A computed contact solution and what it was computed from. Units are those of solids; per
/// unit of thickness, forces of plane bodies are in N/mm.
template <int d>
struct SolvedBody {
  HookeTensors<d> hooke;  ///< per cell [MPa]
  VectorXd displacement;  ///< u_h on all dofs [mm]
  /// at the contact nodes, in the plane (lambda_n, lambda_t) [MPa], in space the forces
  /// (F_n, F_t1, F_t2) [N]
  Matrix<double, d, Dynamic> multipliers;
  ContactLaw<d> law;
  /// moments of the given tractions, as for given_tractions [N, d^2 x boundary]
  FacetColumns<d> neumann;
  BodyLoadsOfCells<d> body_loads;  ///< int f phi_i per cell [N]
  std::shared_ptr<const CondensedStiffness>
      stiffness;  ///< of the solution on the contact; null: factorised if needed
  /// tau0 = sigma0 - C eps0 of sigma = C eps(u) + tau0; empty: none
  LinearStresses<d> initial{};
  /// of which A has the stiffness, and the loads what K u_0 makes of them
  BoundarySprings<d> springs{};
  /// the foundation of a plane body, if forces move it: the law is against where they have
  /// moved it, and what pushes it is a part of the data
  std::optional<RigidTool> tool{};
};

/// sigma = C eps(u) + tau0.
template <int d>
LinearStresses<d> total_stresses(const SimplexMesh<d>& mesh,
                                 const SolvedBody<d>& body,
                                 const Ref<const VectorXd>& displacement) {
  return LinearStresses<d>(stresses(mesh, body.hooke, displacement)) +
         body.initial;
}

/// Moments of the given tractions and of those that the springs answer u_h with [d^2 x
/// SimplexMesh::boundary].
template <int d>
FacetColumns<d> boundary_moments(const SimplexMesh<d>& mesh,
                                 const SolvedBody<d>& body) {
  return with_springs<d>(
      body.neumann, spring_moments<d>(mesh, body.springs, body.displacement));
}

/// What an estimate is asked of.
template <int d>
struct SolvedProblem {
  const Topology<d>& topology;
  const LineOrSurface<d>& contact;
  const ElasticSystem& system;
  const SolvedBody<d>& body;
};

}  // namespace ffcontact
