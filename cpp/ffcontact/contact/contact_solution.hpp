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

/// Did multigrid solve it, or a factor after it?
enum class Multigrid { unused, used, in_vain };

/// A solution of the discrete frictional contact problem [CHH01, Definition 3.1].
template <int d>
struct ContactSolution {
  using NodalVectors = Matrix<double, d, Dynamic>;

  /// anything but converged: the rest is the best iterate
  ContactStatus status = ContactStatus::not_converged;
  VectorXd displacement;  ///< u_h on all dofs [mm]
  /// nodal values (lambda_n, lambda_t) of the multipliers of plane bodies [MPa, 2 x p],
  /// compression < 0; empty for solids
  NodalVectors pressure;
  /// nodal forces (F_n, F_t) [N, d x p], in the plane M (lambda_n, lambda_t) [N/mm]
  NodalVectors force;
  /// per node; of solids slip_forward for slip in any direction
  ContactStates state;
  int iterations = 0;  ///< linear systems of the law solved
  int products = 0;  ///< with the stiffness, by GMRES with multigrid for these
  std::vector<double>
      /// relative change of lambda_n per step of the fixed point; empty where Newton was
      /// enough
      history;
  /// law_violation of displacement and multipliers
  double complementarity = 0;
  double residual = 0;  ///< ResidualDefect of the answer
  /// K and its factor, for further loads and for the estimate; null where multigrid was
  /// enough
  std::shared_ptr<const CondensedStiffness> stiffness;
  /// the relation between P and v that was solved, of plane bodies
  std::shared_ptr<const CondensedContact> contact;
  Multigrid multigrid = Multigrid::unused;

  bool accepted(const ContactSettings& settings) const {
    return status == ContactStatus::converged &&
           complementarity <= settings.tolerance &&
           residual <= settings.tolerance;
  }
};

/// What the measures of a solution make of the status of its condensed answer.
ContactStatus judged_status(ContactStatus condensed, double complementarity,
                            double residual, double tolerance);

/// What a status means, as the end of a sentence.
const char* in_words(ContactStatus status);

}  // namespace ffcontact
