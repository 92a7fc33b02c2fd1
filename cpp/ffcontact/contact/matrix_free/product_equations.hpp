// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/contact/matrix_free/product_relation.hpp"
#include "ffcontact/contact/newton/surface_equations.hpp"

namespace ffcontact {

/// The equations of a step on a ProductRelation (solve_product_step): its unknowns, the
/// rows of the primary ones first, then those of the dependent multipliers, and what they
/// are divided by, so that neither units nor sizes matter. Those of w_o are P_o = 0.
struct ProductEquations {
  const ProductRelation& relation;
  const SurfaceEquations& law;
  std::vector<int> unknown;    ///< of x, ascending
  std::vector<int> dependent;  ///< of q, ascending
  std::vector<Equation>
      equation;    ///< of each unknown, then of each dependent row
  VectorXd unit;   ///< of the unknowns: diag(S)^-1/2, and what q moves
  VectorXd scale;  ///< of the equations

  ProductEquations(const ProductRelation& relation,
                   const SurfaceEquations& law);

  Index size() const { return unit.size(); }
  /// What P and v miss, scaled.
  VectorXd residual(const ContactRows& at) const;
  /// P and v of all rows that an increment makes.
  ContactRows increment(const VectorXd& scaled) const;
  /// The equations' left sides of P and v, scaled.
  VectorXd sums(const ContactRows& rows) const;
  /// The equations' left sides of an increment.
  VectorXd product(const VectorXd& scaled) const;
};

/// r of surface_step's proximal term.
inline constexpr double proximal_share = 1e-8;

}  // namespace ffcontact
