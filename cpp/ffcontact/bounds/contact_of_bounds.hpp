// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/estimate/admissible_pair.hpp"
#include "ffcontact/estimate/bodies/matched_bodies.hpp"

namespace ffcontact {

/// What bounds ask of the contact: lines and surfaces answer each in their own way.

/// As TractionFields.
struct SurfaceDensities {
  Matrix3Xd nodal;
  SurfaceTractions on_faces;
};

/// Contact tractions rho, linear along each contact facet [MPa].
template <int d>
using FacetDensities =
    std::conditional_t<d == 2, ContactDensities, SurfaceDensities>;

/// r_hat of an estimate.
inline ContactDensities facet_densities(const Estimate<2>& estimate) {
  return estimate.tractions;
}
inline SurfaceDensities facet_densities(const Estimate<3>& estimate) {
  return {estimate.tractions, estimate.face_tractions};
}

/// Multipliers of a solution, as in SolvedBody.
inline const Matrix2Xd& multipliers_of(const ContactSolution<2>& solution) {
  return solution.pressure;
}
inline const Matrix3Xd& multipliers_of(const ContactSolution<3>& solution) {
  return solution.force;
}

/// 2 given - moved; nothing given is 0.
template <class Given>
Given on_the_other_side(const Given& given, const Given& moved) {
  return given.size() > 0 ? Given(2 * given - moved) : Given(-moved);
}

/// int rho phi on the dofs of the solved bodies [N]: rho on the contact's body, -rho on the
/// opposite one.
template <int d>
VectorXd nodal_forces(const MatchedBodies<d>& bodies,
                      const FacetDensities<d>& rho);

/// 2 Psi(v, rho) of a law on the contact facets (excess), at least: it is exact in the plane, and in
/// space has FaceCosts for |v_t|, which is a bound that depends on v alone.
template <int d>
VectorXd twice_psi(const MatchedBodies<d>& bodies, const ContactLaw<d>& law,
                   const VectorXd& v, const FacetDensities<d>& rho);

/// Nodal forces under twice the bound of Tresca's law.
template <int d>
ContactLaw<d> with_twice_the_bound(ContactLaw<d> law);

/// Nodal forces, with gap and load step before on the other side of what v has: 2 gap -
/// v_n, 2 previous - v_t.
template <int d>
ContactLaw<d> reflected(const SolvedProblem<d>& solved, const VectorXd& v);

/// Where v keeps clear, and of what.
template <int d>
struct ContactConditions {
  LineOrSurface<d> contact;
  ContactLaw<d> law;
};

/// A small change of v that keeps clear along the facets, at vertices that supports leave
/// free.
template <int d>
VectorXd cleared(const MatchedBodies<d>& bodies,
                 const ContactConditions<d>& conditions, const VectorXd& v);

/// How far v does not, at most.
template <int d>
double depth_of(const MatchedBodies<d>& bodies,
                const ContactConditions<d>& conditions, const VectorXd& v);

}  // namespace ffcontact
