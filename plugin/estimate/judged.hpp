// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/estimate/estimate.hpp"
//
#include "problem/coulomb.hpp"

namespace ffcontact::plugin {

/// A solution that is to be judged: of contactsolve, or given by the script. Its law of
/// elasticity and its loads are those of the estimate.
struct Judged {
  std::shared_ptr<const ElasticSystem> system;
  SolvedBody<2> body;
  ContactForces forces;
  /// of body.law, where contactsolve left it
  std::shared_ptr<const CondensedContact> contact;

  /// K and its factor, for what needs them, if they are not there.
  void factorise(const ContactLine& line);
};
Judged judged_of(const SolvedContact& solved);
/// @param pressures  that the script gives, of this multiplier [2 x p]
Judged judged_of(const ContactProblem<2>& problem, ElasticSystem system,
                 VectorXd displacement, Multiplier multiplier,
                 const Matrix2Xd& pressures);

/// kappa of Coulomb's law and the largest friction of a solution.
/// @param judged  factorised
CoulombConstant coulomb_constant_of(const ContactLine& line,
                                    const Judged& judged, StuckNodes stuck);

/// kappa of Coulomb's law and what it makes of e.
struct CoulombBound {
  CoulombConstant constant;
  double value;  ///< infinite for a pair that is not admissible
  StuckNodes stuck;
};

/// @param judged  factorised
CoulombBound coulomb_bound_of(const ContactLine& line, const Judged& judged,
                              const Estimate<2>& estimate, StuckNodes stuck);

}  // namespace ffcontact::plugin
