// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/bounds/bounded_quantity.hpp"

namespace ffcontact {

/// Bounds with Coulomb's law are those of Tresca's law with the bound mu |r_hat_n| of an
/// estimate, but for the conditions on v and what CoulombTerms adds.

/// @throws std::invalid_argument  where the coefficient varies along an edge, directions turn,
///                                or traces do not match
void require_coulomb_covered(const SolvedProblem<2>& solved,
                             const Estimate<2>& first);

/// Nodal forces under Tresca's law with the bound mu |r_hat_n|: exactly along the edges, at the
/// nodes its mean of both sides.
ContactLaw<2> with_bound_of(ContactLaw<2> law, const ContactLine& line,
                            const ContactDensities& tractions);

/// v_n - gap +- mu (v_t - previous) <= mu |u_hat_t - previous| as two nodes without friction at
/// each node, of directions (n +- mu t) / (1 + mu^2)^(1/2): the second p nodes are those of
/// the minus. Where u_hat_t changes its sign along an edge, 0 stands for |u_hat_t| at both
/// ends.
ContactConditions<2> conditions_of_coulomb(const ContactLine& line,
                                           const ContactLaw<2>& law,
                                           const VectorXd& u_hat);

/// @param bodies  under with_bound_of
/// @param share   mu kappa < 1
CoulombTerms<2> coulomb_terms(const MatchedBodies<2>& bodies,
                              const Estimate<2>& first, double share);

/// v keeps to conditions_of_coulomb, and is sought under m (a(u_hat, .) - L + r_hat) beside
/// L - t l - rho.
/// @param bounded  under with_bound_of
/// @param law      Coulomb's
/// @param share    m = mu kappa < 1
BoundedQuantity<2> with_coulombs_law(BoundedQuantity<2> bounded,
                                     const ContactLaw<2>& law, double share);

}  // namespace ffcontact
