// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/law/compliant_layer.hpp"
#include "ffcontact/interface/contact_line.hpp"

namespace ffcontact {

/// The two discrete convexes of multipliers [CHH01, 3.1]. In both the conditions hold
/// node by node between a multiplier P and a displacement W u, and the body is loaded by
/// W P:
enum class Multiplier {
  pressure,  ///< M'_h (Prop. 3.4): W = M, P = nodal pressures L [MPa]
  force,     ///< M''_h (Prop. 3.5): W = I, P = nodal forces F = M L [N/mm]
};

/// Two functions that are linear on each contact edge and enclose a coefficient there, by
/// their values at its ends [2 x m].
struct EdgeRange {
  Matrix2Xd least, most;
};

/// The law of contact and friction along the line, given at its nodes.
///     P_n <= 0,  v_n <= 0,  P_n v_n = 0
///     |P_t| <= b,  |P_t| < b => v_t = 0,  P_t v_t <= 0
/// for v = W (u_n - gap, u_t - previous) with the bound b = -mu P_n (Coulomb), b =
/// min(-mu P_n, k) with k = shear_limit (Coulomb and Orowan), or b = slip_bound (Tresca);
/// bounds in units of P, M k for nodal forces. Where the line is bonded
///     v = 0,   P of any size and sign
/// takes the place of all of this.
struct ContactLaw {
  Multiplier multiplier = Multiplier::force;
  VectorXd friction;  ///< mu >= 0 at each node [p]; 0 is the frictionless case
  /// Tresca's bound >= 0 at each node [MPa], in place of -mu lambda_n; empty for Coulomb
  VectorXd slip_bound;
  VectorXd gap;  ///< initial gap along n at each node [mm]; empty for none
  /// u_t of the load step before [mm], for the incremental law; empty for the static law
  VectorXd previous;
  /// The coefficient between the nodes, where it is not linear there: mu of Coulomb's
  /// law, k of Tresca's. Empty where it is. The solver knows the nodes alone; tractions
  /// are judged along the edges.
  EdgeRange between_nodes;
  /// largest |lambda_t| of Coulomb's law at each node >= 0 [MPa]; empty for none
  VectorXd shear_limit;
  EdgeRange limit_between_nodes;  ///< of shear_limit likewise
  /// glued to what it faces: friction is 0 then, and nothing else is given
  bool bonded = false;
  CompliantLayer layer{};  ///< in the interface; of nodal forces alone
  /// tractions (r_n, r_t) at the nodes that the layer carries, by which gap and previous are
  /// moved (on_layer) [MPa, 2 x p]; empty: they are not
  Matrix2Xd carried{};

  bool tresca() const { return slip_bound.size() > 0; }
  bool limited() const { return shear_limit.size() > 0; }
};

/// The two lines nearest to the chord that enclose a coefficient >= 0 sampled at evenly
/// spaced points of each edge, ends included: the chord shifted by the largest deviation
/// to either side, or the constant least value where the lower one would fall below 0.
/// Where the samples are on the chord to rounding it is both.
/// @param samples  one column per edge [at least 2 x m]
EdgeRange enclosing_range(const Ref<const MatrixXd>& samples);

/// The law of a line or surface that is bonded to what it faces, as both are drawn: the jump
/// of u is 0, whatever distance there is between them.
template <class Law = ContactLaw>
Law bonded_law(int nodes) {
  Law law;
  law.friction = VectorXd::Zero(nodes);
  law.bonded = true;
  return law;
}

/// @throws std::invalid_argument  if sizes differ from the line's or a coefficient is
///                                negative or not finite
void require_valid(const ContactLaw& law, const ContactLine& line);

/// Contact on the far side of a layer that carries tractions: gap - c_n r_n, previous - c_t
/// r_t. Without a layer the law as it is.
/// @param traction  (r_n, r_t) at the nodes [MPa, 2 x p]
ContactLaw on_layer(ContactLaw law, const Ref<const Matrix2Xd>& traction);

/// What a node does. A node that slides along +t has v_t > 0 and is pulled back, P_t =
/// -b. Tresca's friction does not ask for contact: b is given, and an open node sticks or
/// slips under it like any other.
enum class ContactState : char {
  open,
  stick,
  slip_forward,
  slip_backward,
  /// slip under the shear limit, P_t = -k; within the solver, answers say slip
  limited_forward,
  limited_backward,
  open_stick,  ///< Tresca's law only, within the solver; answers say open
  open_slip_forward,
  open_slip_backward,
};
using ContactStates = std::vector<ContactState>;
inline ContactStates all_stick(int nodes) {
  return ContactStates(nodes, ContactState::stick);
}

/// +1 for slip forward, -1 for slip backward, 0 otherwise.
inline int slip_sign(ContactState state) {
  switch (state) {
    case ContactState::slip_forward:
    case ContactState::limited_forward:
    case ContactState::open_slip_forward: return 1;
    case ContactState::slip_backward:
    case ContactState::limited_backward:
    case ContactState::open_slip_backward: return -1;
    default: return 0;
  }
}

inline bool is_open(ContactState state) {
  return state == ContactState::open || state >= ContactState::open_stick;
}

inline bool is_limited(ContactState state) {
  return state == ContactState::limited_forward ||
         state == ContactState::limited_backward;
}

/// Does a state keep a component (0 normal, 1 tangential) from moving, v = 0?
inline bool holds(ContactState state, int component) {
  return component == 0 ? !is_open(state)
                        : state != ContactState::open && slip_sign(state) == 0;
}

/// W of the law on a line: the mass matrix (3.9) or the identity [p x p].
SparseMatrix weight_matrix(Multiplier multiplier, const ContactLine& line);

/// W for both components, row 2 i + c, so that the forces are W P and v = W (components
/// of a displacement) [2 p x 2 p]. Where neighbours i, j have different normals the
/// vectors are weighted, not the components: block (i, j) is w_ij times the rotation from
/// the frame of j to that of i, and W P is exactly the load of the vector density with
/// nodal values P.
SparseMatrix weight_of_rows(Multiplier multiplier, const ContactLine& line);

/// (u_n - gap, u_t - previous) at the nodes [2 x p] of a displacement on all dofs; jumps
/// where the line faces another body.
Matrix2Xd displacement_against_foundation(
    const ContactLine& line, const ContactLaw& law,
    const Ref<const VectorXd>& displacement);

/// The largest gap or displacement of the load step before [mm]; 0 without.
double largest_given(const ContactLaw& law);

/// The largest component of a displacement, gap or displacement of the load step before
/// [mm]: what displacements on the line are small against.
double largest_displacement(const ContactLaw& law,
                            const Ref<const VectorXd>& displacement);

}  // namespace ffcontact
