// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/contact/contact_solution.hpp"

namespace ffcontact {

/// Solves K u = b + B' P under the law for bodies on a rigid foundation, or against each
/// other (a joined mesh and system, and lines or surfaces with what they face; u_n and u_t
/// are then the jumps [u] . n and [u] . t, and -P acts on the opposite body): one
/// factorisation, the condensed relation between P and v, the chosen solver on it, one
/// back-substitution. Large solids are solved by multigrid where it can, and by a factor
/// where it does not converge.
///
/// The quasi-static path of a load that changes direction is a sequence of such problems
/// with ContactLaw::previous and ContactSettings::initial_state taken from the step
/// before.
///
/// Multipliers at nodes with a prescribed dof: for Multiplier::force no equation gives F
/// there, which is returned as 0; lambda is then 0 or continued from the next node
/// (CondensedContact) and M L = F is solved on the others. For Multiplier::pressure
/// complementarity determines lambda unless W u vanishes identically there; then the same
/// is done.
///
/// Where contact leaves a motion free on which no load works (a body on a frictionless
/// plane), displacements are determined up to it, and one of them is returned.
/// @throws std::invalid_argument  for input that does not fit, prescribed displacements
///                                that penetrate (require_feasible), or
///                                loads that contact cannot balance (with the motion named)
/// @throws std::runtime_error     if a part of the body is held by nothing
ContactSolution<2> solve_contact(const Mesh& mesh, const ContactLine& line,
                                 const ContactLaw<2>& law,
                                 const ElasticSystem& system,
                                 const ContactSettings& settings = {});
ContactSolution<3> solve_contact(const SolidMesh& mesh,
                                 const ContactSurface& surface,
                                 const ContactLaw<3>& law,
                                 const ElasticSystem& system,
                                 const ContactSettings& settings = {});

}  // namespace ffcontact
