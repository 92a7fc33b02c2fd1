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

/// int C eps(v) : eps(v), with the initial stresses, |.|^2 of a stress.
template <int d>
double energy_of(const MatchedBodies<d>& bodies, const VectorXd& v);

/// l(u) <= upper, for t = s, and -l(u) <= upper with t = -s and -l in place of l:
///     upper = l(v) + 1 / (2 s) ( |tau - C eps(v)|^2 / 2 + 2 Psi(v, rho) ),
///     Psi = int k |v_t| + rho_t v_t + rho_n (v_n - gap)
/// for Tresca's law and without friction [theory_of_bounds.md]. This
/// is the second term; C eps(v) with the initial stresses. |.| contains the energy of
/// springs, of t + K (v - u_0), and the oscillation of rho.
template <int d>
double excess(const MatchedBodies<d>& bodies, const BoundPair<d>& pair,
              double s);

/// upper - lower of a pair of bounds as contributions of the cells, which are not negative:
///     |d+ + d-|^2 / (8 s) + |h+ - h-|^2 / (8 s) + sum over all four pairs of Psi(v, rho) / (2 s),
/// d = tau - C eps(v), h = tau + C eps(v); with u = (v+ + v-) / 2 and z = (v- - v+) / (2 s)
/// the first is the error of u, the second that of z, which answers to l. Oscillations add
/// to each cell in proportion to |d|^2 there.
template <int d>
VectorXd width_of_cells(const MatchedBodies<d>& bodies,
                        const BoundPair<d>& plus, const BoundPair<d>& minus,
                        double s);

}  // namespace ffcontact
