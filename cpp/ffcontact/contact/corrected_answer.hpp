// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ffcontact/contact/contact_relation.hpp"
#include "ffcontact/contact/contact_solution.hpp"
#include "ffcontact/contact/residual_defect.hpp"
#include "ffcontact/contact/stated_contact.hpp"

namespace ffcontact {

/// An answer of a relation between P and v, what the whole body makes of it, and its
/// corrections.
template <int d>
class CorrectedAnswer {
 public:
  /// @param stated  outlives it
  CorrectedAnswer(const StatedContact<d>& stated,
                  std::unique_ptr<ContactRelation> relation);

  /// Corrects it, of an inexact stiffness K~ or of rounding: with u the last displacement
  ///     K~ (u' - u) = b - K u + B' P',   (P', v(u')) in the law,
  /// so that u' = u solves the problem itself, as long as that lowers what is missed.
  void correct();

  /// Is more left than rounding? Of an inexact factor, or where a body is much softer than
  /// another: its forces are not much above the rounding of the other's.
  bool is_off() const;

  /// P of the nodes, rows d i + c [d p].
  const VectorXd& multipliers() const { return P_; }

  /// Judged by the balance of loads and contact forces, too. Without pressures, stiffness and
  /// relation.
  ContactSolution<d> solution(const SimplexMesh<d>& mesh) const;

 private:
  /// What the theory promises of an answer, measured.
  struct Missed {
    ResidualDefect residual{};
    double of_law = 0;  ///< law_defect

    double largest() const { return std::max(residual.largest(), of_law); }
  };

  ResidualDefect residual_with(const VectorXd& P) const;
  NewtonSettings limits() const;
  bool can_gain() const;
  RelationAnswer next(const ActiveSetResult& last);
  void take(RelationAnswer answer);
  void drop_rounding();

  const StatedContact<d>& stated_;
  std::unique_ptr<ContactRelation> relation_;
  ActiveSetResult condensed_;
  std::vector<double> history_;
  VectorXd displacement_, P_;
  LawScales scales_;  ///< of the first answer
  Missed missed_;
};

}  // namespace ffcontact
