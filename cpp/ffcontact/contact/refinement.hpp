// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/condensed/condensed_contact.hpp"

namespace ffcontact {

/// A displacement on all dofs and the multipliers of all rows 2 i + c [2 p].
struct BodyAnswer {
  VectorXd displacement, P;
};

/// The law on a layer that carries the multipliers of an answer.
ContactLaw on_layer(const ContactLine& line, const ContactLaw& law,
                    const HeldRows& held, const BodyAnswer& answer);

/// Contact forces W P at the nodes [2 x p].
Matrix2Xd nodal_forces_of(const ContactLine& line, const ContactLaw& law,
                          const VectorXd& P);

/// b + contact forces - K u on the free dofs, 0 on the others.
VectorXd force_residual(const ElasticSystem& system,
                        const VectorXd& displacement,
                        const VectorXd& contact_load);

/// |K u - b - contact forces| on the free dofs, with d (apart) the largest gap or previous
/// displacement, by two measures.
struct ResidualDefect {
  /// Relative to the largest load or force, or, dof by dof, to 1e-4 of the terms that its
  /// row adds up, sum_j |K_ij| (|u_j| + d). The latter is what rounding asks for: 1e-10 of it
  /// are some fifty units in the last place of the terms. It counts where a stiff body moves
  /// much more than it strains, and where nothing but gaps and prescribed motions load the
  /// body.
  double of_forces;
  /// Relative to what its own row may have, sum_j |K_ij| (max |u| + d) + |b_i| + |contact
  /// force|, but not to less than 2.2e-7 of the largest of these, a last place of which is
  /// 1e-9 of that. Rounding of a stiff body is large beside the forces of a soft one, which
  /// of_forces does not see; refinement takes it away.
  double of_rows;

  double largest() const { return std::max(of_forces, of_rows); }
};
ResidualDefect residual_defect(const ElasticSystem& system,
                               const VectorXd& displacement,
                               const VectorXd& contact_load, double apart);

/// The same of an answer on a contact line.
ResidualDefect residual_defect(const ContactLine& line, const ContactLaw& law,
                               const ElasticSystem& system,
                               const HeldRows& held, const BodyAnswer& answer);

/// One step of iterative refinement with the states kept: the residual and the
/// displacements that the states forbid are taken for the loads of a correction
/// (with_loads), which solve_active_set finds without bounds of its own.
/// @param state  the states that the answer was solved for [p]
/// @return the answer itself if the states leave a motion free
BodyAnswer refined(const ContactLine& line, const ContactLaw& law,
                   const ElasticSystem& system,
                   const CondensedStiffness& stiffness,
                   const CondensedContact& contact, const ContactStates& state,
                   const BodyAnswer& answer);

}  // namespace ffcontact
