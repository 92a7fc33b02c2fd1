// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/compliant_layer.hpp"
#include "ffcontact/contact/law/contact_state.hpp"
#include "ffcontact/contact/law/edge_range.hpp"
#include "ffcontact/contact/law/multiplier_weight.hpp"
#include "ffcontact/interface/line_or_surface.hpp"

namespace ffcontact {

/// What only the law along a line has. Solids have nodal forces, and coefficients that are
/// linear on the faces.
template <int d>
struct LawOfLine {};
template <>
struct LawOfLine<2> {
  Multiplier multiplier = Multiplier::force;
  /// The coefficient between the nodes, where it is not linear there: mu of Coulomb's
  /// law, k of Tresca's. Empty where it is. The solver knows the nodes alone; tractions
  /// are judged along the edges.
  EdgeRange between_nodes;
  EdgeRange limit_between_nodes;  ///< of shear_limit likewise
};

/// The law of contact and friction along a line or on a surface, given at its nodes.
///     P_n <= 0,  v_n <= 0,  P_n v_n = 0
///     |P_t| <= b,   v_t = 0 where |P_t| < b,   P_t = -b v_t / |v_t| where v_t != 0
/// for v = W (u_n - gap, u_t - previous) with the bound b = -mu P_n (Coulomb), b =
/// min(-mu P_n, k) with k = shear_limit (Coulomb and Orowan), or b = slip_bound (Tresca);
/// bounds in units of P: of nodal forces M k along lines, k times the area of the node on
/// surfaces (nodal_law). |.| is Euclid's norm, the cone of solids is a circular one. At nodes
/// that are bonded
///     v = 0,   P of any size and direction
/// takes the place of all of this. Nodes of one facet are bonded together or not at all.
template <int d>
struct ContactLaw : LawOfLine<d> {
  using NodalVectors = Matrix<double, d, Dynamic>;

  VectorXd friction;  ///< mu >= 0 at each node [p]; 0 is the frictionless case
  /// Tresca's bound >= 0 at each node [MPa], in place of -mu lambda_n; empty for Coulomb
  VectorXd slip_bound;
  VectorXd gap;  ///< initial gap along n at each node [mm]; empty for none
  /// u_t of the load step before [mm, d - 1 x p], for the incremental law; empty for the
  /// static law
  Matrix<double, d - 1, Dynamic> previous;
  /// largest |lambda_t| of Coulomb's law at each node >= 0 [MPa]; empty for none
  VectorXd shear_limit;
  /// 1 at nodes that are glued to what they face, where all else that is given is 0 [p];
  /// empty for none
  Flags bonded{};
  CompliantLayer layer{};  ///< in the interface; of nodal forces alone
  /// tractions at the nodes that the layer carries, by which gap and previous are moved
  /// (on_layer) [MPa, d x p]; empty: they are not
  NodalVectors carried{};

  bool tresca() const { return slip_bound.size() > 0; }
  bool limited() const { return shear_limit.size() > 0; }
  bool is_bonded(int node) const { return !bonded.empty() && bonded[node]; }
  bool has_bonded() const {
    return std::find(bonded.begin(), bonded.end(), 1) != bonded.end();
  }
  bool slides_nowhere() const {
    return has_bonded() &&
           std::find(bonded.begin(), bonded.end(), 0) == bonded.end();
  }
};

/// The law of a line or surface that is bonded to what it faces, as both are drawn: the jump
/// of u is 0, whatever distance there is between them.
template <int d>
ContactLaw<d> bonded_law(int nodes) {
  ContactLaw<d> law;
  law.friction = VectorXd::Zero(nodes);
  law.bonded.assign(nodes, 1);
  return law;
}

/// Values at the nodes, 0 at those that are bonded.
template <int d, class Columns>
Columns without_bonded(const ContactLaw<d>& law, Columns values) {
  for (int i = 0; i < values.cols(); ++i)
    if (law.is_bonded(i)) values.col(i).setZero();
  return values;
}

/// A coefficient of 1 wherever there is friction, and nodal forces.
template <int d>
ContactLaw<d> as_rough(ContactLaw<d> law) {
  law.friction = law.friction.cwiseSign();
  if constexpr (d == 2) law.multiplier = Multiplier::force;
  return law;
}

/// @throws std::invalid_argument  if sizes differ from those of the line or surface, or a
///                                coefficient is negative or not finite
template <int d>
void require_valid(const ContactLaw<d>& law, const LineOrSurface<d>& where);

/// Contact on the far side of a layer that carries tractions: gap - c_n r_n, previous - c_t
/// r_t. Without a layer the law as it is.
/// @param traction  (r_n, r_t) at the nodes [MPa, d x p]
template <int d>
ContactLaw<d> on_layer(
    ContactLaw<d> law,
    const Ref<const typename ContactLaw<d>::NodalVectors>& traction);

/// (u_n - gap, u_t - previous) at the nodes [d x p] of a displacement on all dofs; jumps
/// where it faces another body.
template <int d>
typename ContactLaw<d>::NodalVectors displacement_against_foundation(
    const LineOrSurface<d>& where, const ContactLaw<d>& law,
    const Ref<const VectorXd>& displacement);

/// The largest gap or displacement of the load step before [mm]; 0 without.
template <int d>
double largest_given(const ContactLaw<d>& law);

/// The largest component of a displacement, gap or displacement of the load step before
/// [mm]: what displacements of contact nodes are small against.
template <int d>
double largest_displacement(const ContactLaw<d>& law,
                            const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
