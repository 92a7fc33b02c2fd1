// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/bounds/contact_of_bounds.hpp"

namespace ffcontact {

/// What one bound of a quantity is made of, on bodies whose traces match: v that is
/// kinematically admissible, tau in equilibrium with the loads and t l, and its contact
/// tractions rho in the cone.
template <int d>
struct BoundPair {
  VectorXd v;
  std::vector<SubcellStress<d>> tau;
  FacetDensities<d> rho;
  double defect = 0;  ///< of tau and rho, relative to the largest stress
  /// moments of the tractions t of springs with tau [d^2 x boundary]; no columns without
  FacetColumns<d> springs{d * d, 0};
  /// PairError::oscillation: stresses in equilibrium with what rho has beyond the linear
  /// part that tau balances, where directions turn, are at most this large
  double oscillation = 0;
};

/// Of an estimate of a body.
template <int d>
BoundPair<d> pair_of(const MatchedBodies<d>& bodies, const SolvedBody<d>& body,
                     const Estimate<d>& estimate);

/// What bounds with Coulomb's law are made of beside the pair [theory_of_bounds.md]: a pair
/// (u_hat, sigma_hat, r_hat) that is known, of which mu kappa bounds the distances to the
/// solution. Tresca's law with the bound mu |r_hat_n| is that of the bodies then, rho is in
/// its cone, and v keeps to v_n - gap + mu |v_t| <= mu |u_hat_t|.
template <int d>
struct CoulombTerms {
  double share;  ///< mu kappa < 1
  BoundPair<d> known;
  ContactLaw<d> frictionless;  ///< the bodies' law without its bound
  VectorXd friction;  ///< 2 int mu |r_hat_n| |u_hat_t| on the contact facets
  VectorXd error;     ///< |d_hat|^2 of each cell (error_of)
};

/// int C eps(v) : eps(v), with the initial stresses, |.|^2 of a stress.
template <int d>
double energy_of(const MatchedBodies<d>& bodies, const VectorXd& v);

/// |tau - C eps(v)|^2 of each cell, and of the springs beside it.
template <int d>
VectorXd error_of(const MatchedBodies<d>& bodies, const BoundPair<d>& pair);

/// l(u) <= upper, for t = s, and -l(u) <= upper with t = -s and -l in place of l:
///     upper = l(v) + 1 / (2 s) ( |tau - C eps(v)|^2 / 2 + 2 Psi(v, rho) ),
///     Psi = int k |v_t| + rho_t v_t + rho_n (v_n - gap)
/// for Tresca's law and without friction [theory_of_bounds.md]. This
/// is the second term; C eps(v) with the initial stresses. |.| contains the energy of
/// springs, of t + K (v - u_0), and the oscillation of rho. With Coulomb's law Psi is
///     int mu |r_hat_n| |u_hat_t| + rho_t v_t + rho_n (v_n - gap)
/// and m / 2 (|d_hat|^2 + |h - h_hat|^2 / (1 - m)) is added to what is divided by 2 s, m = mu
/// kappa, d and h as below.
/// @param coulomb  null for other laws
template <int d>
double excess(const MatchedBodies<d>& bodies, const BoundPair<d>& pair,
              double s, const CoulombTerms<d>* coulomb = nullptr);

/// upper - lower of a pair of bounds as contributions of the cells, which are not negative:
///     |d+ + d-|^2 / (8 s) + |h+ - h-|^2 / (8 s) + sum over all four pairs of Psi(v, rho) / (2 s),
/// d = tau - C eps(v), h = tau + C eps(v); with u = (v+ + v-) / 2 and z = (v- - v+) / (2 s)
/// the first is the error of u, the second that of z, which answers to l. Oscillations add
/// to each cell in proportion to |d|^2 there. With Coulomb's law parts of Psi may be below 0:
/// what cells have less than nothing is taken from the others in proportion.
template <int d>
VectorXd width_of_cells(const MatchedBodies<d>& bodies,
                        const BoundPair<d>& plus, const BoundPair<d>& minus,
                        double s, const CoulombTerms<d>* coulomb = nullptr);

}  // namespace ffcontact
