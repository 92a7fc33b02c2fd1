// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/active_set/active_set.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"
#include "ffcontact/contact/contact_settings.hpp"
#include "ffcontact/contact/law/contact_law.hpp"

namespace ffcontact {

/// A solution of Coulomb's discrete frictional contact problem [CHH01, Definition 3.1].
struct ContactSolution {
  /// anything but converged: the rest is the best iterate
  ContactStatus status = ContactStatus::not_converged;
  VectorXd displacement;  ///< u_h on all dofs [mm]
  /// nodal values (lambda_n, lambda_t) of the multipliers [MPa], compression < 0
  Matrix2Xd pressure;
  Matrix2Xd force;  ///< nodal forces (F_n, F_t) = M (lambda_n, lambda_t) [N/mm]
  ContactStates state;  ///< per node
  int iterations = 0;   ///< dense systems solved
  std::vector<double>
      /// relative change of lambda_n per step of the fixed point; empty where Newton was
      /// enough
      history;
  /// complementarity_defect of the answer
  double complementarity = 0;
  double residual = 0;  ///< residual_defect of the answer
  /// K and its factor, for further loads and for the estimate
  std::shared_ptr<const CondensedStiffness> stiffness;
  /// the relation between P and v that was solved
  std::shared_ptr<const CondensedContact> contact;

  bool accepted(const ContactSettings& settings) const {
    return status == ContactStatus::converged &&
           complementarity <= settings.tolerance &&
           residual <= settings.tolerance;
  }
};

/// Solves K u = b + B' P under the conditions of Prop. 3.4 / 3.5 for a body on a rigid
/// foundation, or for bodies against each other (a joined mesh and system, and lines with
/// their opposite bodies; u_n and u_t are then the jumps [u] . n and [u] . t, and -P acts
/// on the opposite body): one factorisation, the condensed relation between P and v, the
/// chosen solver on it, one back-substitution.
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
ContactSolution solve_contact(const Mesh& mesh, const ContactLine& line,
                              const ContactLaw& law,
                              const ElasticSystem& system,
                              const ContactSettings& settings = {});

/// States of a new line from those of an earlier one (the mesh before adaptation): of the
/// old node nearest in abscissa.
/// @throws std::invalid_argument  if the sizes of the old arrays differ
ContactStates states_at(const ContactLine& line,
                        const Ref<const VectorXd>& old_abscissa,
                        const ContactStates& old_state);

/// What the measures of a solution make of the status of its condensed answer.
ContactStatus judged_status(ContactStatus condensed, double complementarity,
                            double residual, double tolerance);

/// What a status means, as the end of a sentence.
const char* in_words(ContactStatus status);

}  // namespace ffcontact
