// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "ffcontact/contact/checks/sliding_motions.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
//
#include "problem/contact_type.hpp"
#include "solve/solve_call.hpp"

namespace ffcontact::plugin {

/// Rigid motions that nothing but noise of the geometry resists or drives.
template <int d>
struct HeldSliding {
  MatrixXd motions;           ///< [dofs x k]
  BodyLoadsOfCells<d> loads;  ///< that hold them; no columns where none have to
};

/// They move no force: of the displacements that differ by them the one that has none of
/// them.
template <int d>
void take_out(const SimplexMesh<d>& mesh, const MatrixXd& motions,
              VectorXd& displacement) {
  if (motions.cols() == 0) return;
  const VectorXd volumes = lumped_volumes(mesh);
  displacement -=
      motions *
      lumped_coefficients(volumes, motions, volumes.cwiseProduct(displacement));
}

template <int d>
void say_held(const SimplexMesh<d>& mesh, const HeldSliding<d>& held,
              double turned) {
  cout << "contactsolve: nothing resists a "
       << motion_in_words(mesh, held.motions.col(0))
       << " but noise of the geometry, which is taken out: contact directions "
          "are turned by at most "
       << turned << " rad, and loads are balanced" << endl;
}

/// Finds them, turns contact directions across them, balances the system's load along
/// them, and says so at verbosity 1.
template <int d>
HeldSliding<d> hold_against_noise(const SolveCall& call,
                                  ContactProblem<d>& problem,
                                  ElasticSystem& system) {
  const SimplexMesh<d>& mesh = problem.mesh;
  HeldSliding<d> held{
      rigid_motions(mesh, problem.contact, problem.law, system).sliding, {}};
  if (held.motions.cols() == 0) return held;
  const double turned = turn_across(held.motions, problem.contact);
  held.loads = holding_loads(mesh, held.motions, system.load);
  add_body_loads(mesh, held.loads, system.load);
  const bool changed = turned > 0 || held.loads.cols() > 0;
  if (changed && call.verbosity() > 0 && mpirank == 0)
    say_held(mesh, held, turned);
  return held;
}

/// Puts the system of a call into what is solved, held against noise.
/// @return the motions that are held
template <int d>
MatrixXd put_system(const SolveCall& call, ContactOf<d>& contact,
                    SolvedContact<d>& solved) {
  ContactProblem<d>& problem = *contact.problem;
  ElasticSystem system = system_of(call, problem, problem.mesh);
  // and stays: what a solution left belongs to its line or surface
  if (!contact.solved) problem.choose_sides(system);
  HeldSliding<d> held = hold_against_noise(call, problem, system);
  solved.holding = std::move(held.loads);
  solved.system = std::make_shared<const ElasticSystem>(std::move(system));
  return held.motions;
}

}  // namespace ffcontact::plugin
