// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/estimate/estimate.hpp"
#include "solid_case.hpp"
#include "trial.hpp"

/// What must hold of every answer about a solid, by plain loops.
namespace ffcontact::fuzz {

/// balance: K u = b + contact forces on the free dofs (1e-10 of the largest terms, 1e-9
/// of the row's own); support: prescribed values; law: contact and friction node by node
/// (1e-9), with Coulomb's friction against the motion.
Finds solid_solution_finds(const SolidCase& problem,
                           const ContactSolution<3>& solution);

/// pair: u_hat keeps supports and clears what it faces; stress: in equilibrium inside
/// every subtetrahedron and across every face, given tractions, contact tractions and
/// their reactions on the other bodies; cone: tractions at many places of every contact
/// face; error: e^2 summed anew.
Finds solid_estimate_finds(const SolidCase& problem,
                           const ContactSolution<3>& solution,
                           const Estimate<3>& estimate);

/// bound: without friction, on a rigid plane, |u - u_hat| <= e for the solution u on
/// tetrahedra cut into eight.
Finds solid_bound_finds(const SolidCase& problem, const Estimate<3>& estimate);

/// States, solves, estimates and judges a random solid.
Outcome outcome_of(const SolidCase& problem);

}  // namespace ffcontact::fuzz
