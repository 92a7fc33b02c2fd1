// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <type_traits>

#include "ffcontact/estimate/estimate.hpp"
//
#include "problem/contact_type.hpp"
#include "problem/coulomb.hpp"

namespace ffcontact::plugin {

/// What kappa of Coulomb's law needs besides.
struct OfJudgedLine {
  ContactForces forces;
  /// of body.law, where contactsolve left it
  std::shared_ptr<const CondensedContact> contact;
};
struct OfJudgedSurface {
  ContactStates state;  ///< of the nodes
};

/// A solution that is to be judged: of contactsolve, or given by the script. Its law of
/// elasticity and its loads are those of the estimate.
template <int d>
struct Judged : std::conditional_t<d == 2, OfJudgedLine, OfJudgedSurface> {
  std::shared_ptr<const ElasticSystem> system;
  SolvedBody<d> body;
};

Judged<2> judged_of(const SolvedContact<2>& solved);
Judged<3> judged_of(const SolvedContact<3>& solved);
/// @param pressures  that the script gives, of this multiplier [2 x p]
Judged<2> judged_of(const ContactProblem<2>& problem, ElasticSystem system,
                    VectorXd displacement, Multiplier multiplier,
                    const Matrix2Xd& pressures);

/// K and its factor, for what needs them, if they are not there.
void factorise(const ContactLine& line, Judged<2>& judged);

/// kappa of Coulomb's law and the largest friction of a solution.
/// @param judged  factorised
CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const Judged<2>& judged, StuckNodes stuck);

}  // namespace ffcontact::plugin
