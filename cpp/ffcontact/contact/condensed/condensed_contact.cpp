// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/condensed_contact.hpp"

#include <utility>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/unheld_bodies.hpp"
#include "ffcontact/contact/condensed/layer_springs.hpp"
#include "ffcontact/contact/condensed/vertex_motions.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/elastic/factor/null_motions.hpp"
#include "ffcontact/linear/dense/congruent.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/selected_rows.hpp"
#include "ffcontact/linear/sparse_lu.hpp"

namespace ffcontact {

namespace {

/// A of the primary rows, for w and for w_o:   v_primary = A w + A_o w_o.
SparseMatrix own_A(const CondensedContact& contact) {
  const SparseMatrix A = selected_rows(contact.A, contact.primary);
  return A.leftCols(count_of(contact.primary));
}
SparseMatrix opposite_A(const CondensedContact& contact) {
  const SparseMatrix A = selected_rows(contact.A, contact.primary);
  return A.rightCols(A.cols() - A.rows());
}

SparseLu primary_factor(const CondensedContact& contact) {
  SparseLu factor(own_A(contact));
  if (!factor.is_regular())
    refuse(
        "the contact multipliers are not independent: the contact line turns "
        "too sharply between prescribed vertices");
  return factor;
}

MatrixXd symmetric_part(const MatrixXd& M) { return 0.5 * (M + M.transpose()); }

/// What the relation is made of, in terms of w and w_o.
struct Terms {
  MatrixXd S;            ///< [f + o x f + o]
  MatrixXd A_dependent;  ///< [d x f + o]
};

/// The leading block of a matrix that is not needed any more.
MatrixXd leading_block(MatrixXd&& M, Index size) {
  if (M.rows() == size) return std::move(M);
  return M.topLeftCorner(size, size);
}

/// S and E as if w_o were given, S = A^-T S_w A^-1 and E = A^-T A_dependent'.
void put_own_relation(Terms&& terms, const SparseLu& factor,
                      CondensedContact& contact) {
  const Index f = count_of(contact.primary);
  contact.S = factor.congruent(leading_block(std::move(terms.S), f));
  contact.E = factor.solve_transposed_columns(
      terms.A_dependent.leftCols(f).transpose());
}

/// The relation between v, w_o and the multipliers before w_o is condensed, loads apart:
///     S v + V' w_o = P + E q,   V v + O w_o = E_o q,   v_dependent = E' v + E_o' w_o.
struct OppositeTerms {
  MatrixXd V, O, E;
};

/// By w = A^-1 (v - v_prescribed) - X w_o with X = A^-1 A_o.
OppositeTerms opposite_terms(const Terms& terms, const SparseLu& factor,
                             const CondensedContact& contact) {
  const Index f = count_of(contact.primary), o = contact.A.cols() - f;
  const MatrixXd &S = terms.S, &A = terms.A_dependent;
  const MatrixXd X = factor.solve_columns(opposite_A(contact));
  const MatrixXd S_ow =
      S.bottomLeftCorner(o, f) - transposed_product(X, S.topLeftCorner(f, f));
  OppositeTerms result;
  result.V = factor.solve_transposed_columns(S_ow.transpose()).transpose();
  result.O = S.bottomRightCorner(o, o) - product(S_ow, X) -
             transposed_product(X, S.topRightCorner(f, o));
  result.E = A.rightCols(o).transpose() -
             transposed_product(X, A.leftCols(f).transpose());
  return result;
}

/// R O R with a diagonal of 1.
void factorize_opposite(const MatrixXd& O, CondensedContact& contact) {
  contact.opposite_scale =
      O.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const auto R = contact.opposite_scale.asDiagonal();
  contact.opposite_stiffness.emplace(MatrixXd(R * symmetric_part(O) * R));
  if (!contact.opposite_stiffness->is_positive_definite() ||
      contact.opposite_stiffness->reciprocal_condition() < 1e-15)
    throw UnheldBodies(
        "the bodies are not held, even with their contact sides glued to each "
        "other");
}

/// w_o = O^-1 (h + E_o q - V v) put into the relation, loads apart.
void condense_opposite(const OppositeTerms& terms, CondensedContact& contact) {
  contact.opposite_of_v = MatrixXd::Zero(terms.V.rows(), terms.V.cols());
  contact.opposite_of_q = MatrixXd::Zero(terms.E.rows(), terms.E.cols());
  contact.F = MatrixXd::Zero(terms.E.cols(), terms.E.cols());
  if (terms.O.rows() == 0) return;
  factorize_opposite(terms.O, contact);
  const auto R = contact.opposite_scale.asDiagonal();
  const Cholesky& O = *contact.opposite_stiffness;
  contact.opposite_of_v = R * O.solve_columns(-(R * terms.V));
  contact.S += transposed_product(terms.V, contact.opposite_of_v);
  contact.S = symmetric_part(contact.S);
  contact.opposite_of_q = R * O.solve_columns(R * terms.E);
  contact.E += transposed_product(contact.opposite_of_v, terms.E);
  contact.F = transposed_product(terms.E, contact.opposite_of_q);
}

/// w_o = O^-1 (h + E_o q - V v), the part of h.
void put_opposite_loads(const VectorXd& h, CondensedContact& contact) {
  const VectorXd& R = contact.opposite_scale;
  contact.opposite_offset +=
      R.cwiseProduct(contact.opposite_stiffness->solve(R.cwiseProduct(h)));
  contact.g += contact.opposite_of_v.transpose() * h;
  contact.dependent_offset += contact.opposite_of_q.transpose() * h;
}

/// Of the components (w, w_o).
VectorXd body_load(const CondensedContact& contact) {
  VectorXd g = contact.to_kept.transpose() * contact.load.on_kept;
  const VectorXd& opposite = contact.opposite_load;
  if (opposite.size() > 0) g.tail(opposite.size()) += opposite;
  return g;
}

/// g and the offsets for a load and the v of prescribed values, by which the relation is
/// one of v - v_prescribed: in whatever accuracy S is, v = v_prescribed needs no force.
void put_loads(const CondensedStiffness& stiffness, const VectorXd& load,
               const VectorXd& v_prescribed, const SparseLu& factor,
               CondensedContact& contact) {
  const Index f = count_of(contact.primary), o = contact.A.cols() - f;
  const VectorXd given = v_prescribed(contact.primary);
  contact.v_prescribed = v_prescribed;
  contact.load = stiffness.condensed(load);
  const VectorXd g_w = body_load(contact),
                 own = factor.solve_transposed(g_w.head(f));
  contact.g = own + contact.S * given;
  contact.dependent_offset =
      v_prescribed(contact.dependent) - contact.E.transpose() * given;
  contact.opposite_offset = -contact.opposite_of_v * given;
  if (o == 0) return;
  const SparseMatrix A_o = opposite_A(contact);
  put_opposite_loads(g_w.tail(o) - A_o.transpose() * own, contact);
}

/// S_w, of bodies that contact alone holds without stiffness of rounding against their
/// motions.
MatrixXd stiffness_of_bodies(const CondensedContact& contact,
                             const MatrixXd& S) {
  if (contact.free_motions.cols() == 0) return congruent(S, contact.to_kept);
  return congruent(without_stiffness_of(contact.free_motions, S),
                   contact.to_kept);
}

/// With the springs of a layer.
MatrixXd body_stiffness(const CondensedContact& contact, const MatrixXd& S) {
  MatrixXd S_w = stiffness_of_bodies(contact, S);
  const VectorXd& layer = contact.layer_stiffness;
  if (layer.size() > 0) S_w.diagonal().tail(layer.size()) += layer;
  return S_w;
}

/// The relation, loads apart.
void put_relation(const CondensedStiffness& stiffness, const SparseLu& factor,
                  CondensedContact& contact) {
  Terms terms{body_stiffness(contact, stiffness.schur()),
              selected_rows(contact.A, contact.dependent)};
  const OppositeTerms opposite = opposite_terms(terms, factor, contact);
  put_own_relation(std::move(terms), factor, contact);
  condense_opposite(opposite, contact);
}

}  // namespace

VectorXd loading_multipliers(const CondensedContact& contact, VectorXd P) {
  for (Index d = 0; d < count_of(contact.dependent); ++d)
    if (!contact.loads_the_body(d)) P[contact.dependent[d]] = 0;
  return P;
}

void number_rows(const std::vector<int>& primary, int row_count,
                 CondensedContact& contact) {
  constexpr int not_yet = -1;
  contact.primary = primary;
  contact.position = VectorXi::Constant(row_count, not_yet);
  for (std::size_t k = 0; k < primary.size(); ++k)
    contact.position[primary[k]] = static_cast<int>(k);
  for (int row = 0; row < row_count; ++row) {
    if (contact.position[row] != not_yet) continue;
    contact.position[row] = -1 - count_of(contact.dependent);
    contact.dependent.push_back(row);
  }
}

std::vector<int> contact_dofs(const ContactLine& line,
                              const ElasticSystem& system) {
  return free_dofs_at(contact_vertices(line), system);
}

CondensedContact condensed_contact(ContactTrace trace,
                                   const std::vector<int>& primary,
                                   const VectorXd& load,
                                   const CondensedStiffness& stiffness) {
  CondensedContact contact;
  static_cast<ContactTrace&>(contact) = std::move(trace);
  number_rows(primary, static_cast<int>(contact.A.rows()), contact);
  const SparseLu factor = primary_factor(contact);
  put_relation(stiffness, factor, contact);
  put_loads(stiffness, load, VectorXd(contact.v_prescribed), factor, contact);
  return contact;
}

CondensedContact condensed_contact(const ContactLine& line,
                                   const ContactLaw<2>& law,
                                   const ElasticSystem& system,
                                   const CondensedStiffness& stiffness,
                                   const FoundationMotions& foundation,
                                   const MatrixXd& free_motions) {
  const VertexMotions motions = vertex_motions(line, system.prescribed);
  if (motions.rows.empty())
    refuse("every dof of the contact line is prescribed");
  HeldRows<2> held = held_rows(line, law, system);
  const SparseMatrix W = weight_of_rows(law.multiplier, line);
  const Matrix2Xd v =
      steered_displacement(line, law, held, system.prescribed_value);
  ContactTrace trace;
  trace.kept_dofs = contact_dofs(line, system);
  trace.to_kept = kept_operator(motions, trace.kept_dofs);
  trace.A = W * trace_operator(line, held.row, motions);
  trace.v_prescribed = W * v.reshaped();
  add_motions(foundation, law, held.row, W, trace);
  add_layer(nodal_compliance(law.layer, nodal_lengths(line), 2, held.row),
            trace);
  if (free_motions.cols() > 0)
    trace.free_motions = free_motions(trace.kept_dofs, Eigen::all);
  CondensedContact contact =
      condensed_contact(std::move(trace), motions.rows, system.load, stiffness);
  contact.held = std::move(held.row);
  const std::vector<int> continued = continued_rows(line, system.prescribed);
  for (int row : contact.dependent) contact.continued.push_back(continued[row]);
  return contact;
}

CondensedContact with_loads(CondensedContact contact,
                            const CondensedStiffness& stiffness,
                            const VectorXd& load,
                            const VectorXd& v_prescribed) {
  put_loads(stiffness, load, v_prescribed, primary_factor(contact), contact);
  return contact;
}

void put_carried(const VectorXd& P, CondensedContact& contact) {
  const Index springs = contact.layer_stiffness.size();
  const SparseMatrix on_rows = contact.A.rightCols(springs);
  contact.opposite_load.tail(springs) = -(on_rows.transpose() * P);
}

BodyRelation body_relation(const CondensedContact& contact,
                           const CondensedStiffness& stiffness) {
  return {body_stiffness(contact, stiffness.schur()), body_load(contact)};
}

VectorXd opposite_displacement(const CondensedContact& contact,
                               const VectorXd& v, const VectorXd& q) {
  return contact.opposite_offset + contact.opposite_of_v * v +
         contact.opposite_of_q * q;
}

VectorXd kept_displacement(const CondensedContact& contact, const VectorXd& v,
                           const VectorXd& q) {
  VectorXd w(contact.A.cols());
  w.tail(contact.A.cols() - v.size()) = opposite_displacement(contact, v, q);
  const VectorXd from_opposite =
      opposite_A(contact) * w.tail(contact.A.cols() - v.size());
  w.head(v.size()) = primary_factor(contact).solve(
      v - contact.v_prescribed(contact.primary) - from_opposite);
  return contact.to_kept * w;
}

}  // namespace ffcontact
