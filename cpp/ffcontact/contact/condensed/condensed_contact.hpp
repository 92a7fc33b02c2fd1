// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/contact/condensed/contact_trace.hpp"
#include "ffcontact/contact/condensed/foundation_motions.hpp"
#include "ffcontact/contact/law/held_rows.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/linear/dense/cholesky.hpp"

namespace ffcontact {

/// The body as the contact conditions see it: a small dense relation between multipliers
/// P and v = W (u_n - gap, u_t - previous).
///
/// Row dim i + c stands for component c (0 normal, others tangential) of node i. Rows are
/// primary, as many as the contact vertices have free dofs, or dependent: a row whose dof
/// is prescribed, or that of the second node at a corner. With S u_c = g + W'P from
/// CondensedStiffness and v = A w in terms of the free components w,
///     P = S v - g - E q,    v_dependent = E' v + offset,    E = A_primary^-T A_dependent',
/// where P and v are those of the primary rows and q are the multipliers of the dependent
/// rows.
///
/// Against other bodies v = A w + A_o w_o with the free components w_o of the opposite
/// vertices, which carry no multipliers of their own. In the unknowns (v, w_o) the
/// stiffness is S~, and w_o is condensed too,
///     w_o = S~_oo^-1 (g~_o + E_o q - S~_ov v),
/// which leaves the same relation, with F = E_o' S~_oo^-1 E_o added:   v_dependent = E' v + F q + offset.
/// S~_oo is the stiffness with the traces glued to each other, hence definite when
/// contact can hold the bodies at all.
///
/// At a vertex with one free dof the primary row is the normal one unless the dof is
/// tangential.
struct CondensedContact : ContactTrace {
  Flags held;                  ///< of a contact line, of HeldRows [rows]
  std::vector<int> primary;    ///< row of each primary unknown [f]
  std::vector<int> dependent;  ///< row of each dependent unknown [d]
  /// continued_rows of the dependent ones of a contact line [d]
  std::vector<int> continued;
  /// of each row: its place in `primary`, or -1 - its place in `dependent` [rows]
  VectorXi position;
  CondensedStiffness::Load load;  ///< on all dofs, as the body's factor sees it
  MatrixXd S;                     ///< [f x f]
  VectorXd g;                     ///< [f]
  MatrixXd E;                     ///< [f x d]
  MatrixXd F;                     ///< [d x d], zero on a rigid foundation
  VectorXd dependent_offset;      ///< [d]
  /// w_o = opposite_offset + opposite_of_v v + opposite_of_q q [o]
  VectorXd opposite_offset;
  MatrixXd opposite_of_v;   ///< [o x f]
  MatrixXd opposite_of_q;   ///< [o x d]
  VectorXd opposite_scale;  ///< R = diag(S~_oo)^-1/2 [o]
  std::optional<Cholesky>
      opposite_stiffness;  ///< of R S~_oo R; nothing if o = 0

  bool is_primary(int row) const { return position[row] >= 0; }
  /// Does the multiplier of dependent row d do anything to a body? Nodal forces on
  /// prescribed dofs do not.
  bool loads_the_body(Index d) const {
    return !E.col(d).isZero(0) || !F.col(d).isZero(0);
  }
};

/// P without the multipliers that do nothing to a body: friction where supports hold the
/// line is what mu makes of it, 1e28 for friction=1e30, and no scale for what does.
VectorXd loading_multipliers(const CondensedContact& contact, VectorXd P);

/// Fills primary, dependent and position.
/// @param primary    rows [f]; of nodes of one vertex those of the first are
/// @param row_count  of all rows
void number_rows(const std::vector<int>& primary, int row_count,
                 CondensedContact& contact);

/// The free dofs of the vertices on the line, in the order of its nodes, then those of
/// the opposite vertices.
std::vector<int> contact_dofs(const ContactLine& line,
                              const ElasticSystem& system);

/// @param primary  rows whose v the own components w determine, one each [f]
/// @throws std::invalid_argument  if the rows are not independent
CondensedContact condensed_contact(ContactTrace trace,
                                   const std::vector<int>& primary,
                                   const VectorXd& load,
                                   const CondensedStiffness& stiffness);

/// @param free_motions  unheld_motions of the bodies [dofs x k], none: not known
/// @throws std::invalid_argument  if the contact line has no free dof
/// @throws std::runtime_error     if foundation and body are not held by each other
CondensedContact condensed_contact(const ContactLine& line,
                                   const ContactLaw<2>& law,
                                   const ElasticSystem& system,
                                   const CondensedStiffness& stiffness,
                                   const FoundationMotions& foundation = {},
                                   const MatrixXd& free_motions = {});

/// The same relation for another load on all dofs and other v of the prescribed values:
/// that of a correction, for instance.
CondensedContact with_loads(CondensedContact contact,
                            const CondensedStiffness& stiffness,
                            const VectorXd& load, const VectorXd& v_prescribed);

/// For corrections of a solution whose layer carries P already: they are loaded by what its
/// springs answer to it.
/// @param P  of all rows
void put_carried(const VectorXd& P, CondensedContact& contact);

/// The bodies in the components z = (w, w_o) of the trace:   S z = g + A'P,   v = A z + v_prescribed.
struct BodyRelation {
  MatrixXd S;  ///< [f + o x f + o]
  VectorXd g;  ///< [f + o]
};
BodyRelation body_relation(const CondensedContact& contact,
                           const CondensedStiffness& stiffness);

/// w_o of the opposite components for v on the primary rows and multipliers q of the
/// dependent ones.
VectorXd opposite_displacement(const CondensedContact& contact,
                               const VectorXd& v, const VectorXd& q);

/// Displacement of the kept dofs that has the given v on the primary rows under the
/// multipliers q of the dependent rows [kept].
VectorXd kept_displacement(const CondensedContact& contact, const VectorXd& v,
                           const VectorXd& q);

}  // namespace ffcontact
