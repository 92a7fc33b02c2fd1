// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/contact/condensed/condensed_rows.hpp"
#include "ffcontact/contact/condensed/surface_trace.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"

namespace ffcontact {

/// The relation of CondensedContact without a dense matrix: Schur's complement S is known
/// by its products (SchurProducts), and opposite components are not condensed.
///
/// Unknown are x = (v of the primary rows, w_o of the opposite components). Where own
/// components are v themselves on a rigid foundation,
///     u_c = T (x - given),   T = to_kept [1 -A_o; 0 1],   given = (v_prescribed, 0),
///     (P, P_o) = T' S T x - g - E q,   v_dependent = E' x + offset,   P_o = 0,
/// with T and E sparse.
///
/// Rows 3 i + c are those of CondensedContact; behind them stands one for each w_o.
struct ProductRelation {
  std::shared_ptr<const CondensedStiffness> stiffness;
  std::unique_ptr<const SchurProducts> S;
  std::vector<int> primary, dependent;  ///< rows [f], [d]
  VectorXi position;                    ///< of CondensedContact [3 p]
  SparseMatrix T;                       ///< [kept x f + o]
  SparseMatrix E;                       ///< [f + o x d]
  /// of T' S T where two unknowns are of one vertex; of S what is between vertices is left
  /// out there [f + o x f + o]
  SparseMatrix blocks;
  std::vector<int> vertex;  ///< of each unknown [f + o]
  /// that a force on a primary row alone meets, by diagonals: its own in series with what
  /// it faces, near diag(S) of CondensedContact [f]
  VectorXd row_stiffness;
  /// x of aggregates of vertices that move along an axis (aggregated_motions)
  SparseMatrix motions;
  CondensedStiffness::Load load;
  VectorXd given;             ///< [f + o]
  VectorXd g;                 ///< [f + o]
  VectorXd dependent_offset;  ///< [d]

  Index size() const { return T.cols(); }
  /// Rows of the nodes and of w_o.
  Index row_count() const {
    return position.size() + size() - count_of(primary);
  }
  /// Of unknown k.
  int row(Index k) const;
};

ProductRelation product_relation(
    const SurfaceTrace& trace, const ElasticSystem& system,
    std::shared_ptr<const CondensedStiffness> stiffness);

/// For a load on all dofs and the v of prescribed values.
void put_loads(const VectorXd& load, const VectorXd& v_prescribed,
               ProductRelation& relation);

/// T' S T x
VectorXd product(const ProductRelation& relation, const VectorXd& x);

/// What a change of the unknowns makes of P and v of all rows [row_count].
ContactRows change_of_rows(const ProductRelation& relation, const VectorXd& x,
                           const VectorXd& q);

/// P and v of all rows that the unknowns make [row_count].
ContactRows rows_of(const ProductRelation& relation, const VectorXd& x,
                    const VectorXd& q);

/// As law_scales of CondensedContact.
LawScales law_scales(const ProductRelation& relation, const VectorXd& v);

/// The displacement of the kept dofs [kept].
VectorXd kept_displacement(const ProductRelation& relation,
                           const ContactRows& rows);

/// Of v = Q v_a, where w_o of aggregates of opposite vertices is such that it is balanced.
struct CoarseRelation;
CoarseRelation coarse_relation(const ProductRelation& relation,
                               const SparseMatrix& Q);

}  // namespace ffcontact
