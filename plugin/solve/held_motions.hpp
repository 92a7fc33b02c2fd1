// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/checks/line_balance.hpp"
#include "ffcontact/contact/checks/sliding_motions.hpp"
#include "ffcontact/contact/checks/surface_balance.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"
//
#include "problem/contact_problem.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// Rigid motions that nothing but the noise of coordinates resists or drives.
template <int d>
struct HeldMotions {
  MatrixXd motions;           ///< [dofs x k]
  BodyLoadsOfCells<d> loads;  ///< that hold them; no columns where none do

  /// They move no force: of the displacements that differ by them the one that has none of
  /// them.
  void take_out_of(const SimplexMesh<d>& mesh, VectorXd& displacement) const {
    if (motions.cols() == 0) return;
    const VectorXd momentum =
        sum_at_vertices(mesh, lumped_loads(mesh, displacement));
    displacement -= motions * lumped_coefficients(mesh, motions, momentum);
  }
};

/// own_normal goes with the contact directions.
inline void put_own_normals(Carrier<2>& line) {
  for (int i = 0; i < line.contact.node_count(); ++i) {
    const Vector2d normal = line.contact.normal.col(i);
    const double side = line.own_normal.col(i).dot(normal) < 0 ? -1 : 1;
    line.own_normal.col(i) = side * normal;
  }
}

/// Finds them, turns contact directions across them, balances the system's load along
/// them, and says so at verbosity 1.
template <int d>
HeldMotions<d> hold_against_noise(const SolveCall& call,
                                  ContactProblem<d>& problem,
                                  ElasticSystem& system) {
  const SimplexMesh<d>& mesh = problem.mesh;
  HeldMotions<d> held{
      sliding_motions(mesh, problem.contact, problem.law, system), {}};
  if (held.motions.cols() == 0) return held;
  const double turned = turn_across(held.motions, problem.contact);
  if constexpr (d == 2) put_own_normals(problem);
  const VectorXd force = holding_force(mesh, held.motions, system.load);
  if (force.size() > 0) {
    held.loads = lumped_loads(mesh, force);
    system.load += sum_at_vertices(mesh, held.loads);
  }
  if ((turned > 0 || force.size() > 0) && call.verbosity() > 0 && mpirank == 0)
    cout << "contactsolve: nothing resists a "
         << motion_in_words(mesh, held.motions.col(0))
         << " but noise of the geometry, which is taken out: contact "
            "directions are turned by at most "
         << turned << " rad, and loads are balanced" << endl;
  return held;
}

}  // namespace ffcontact::plugin
