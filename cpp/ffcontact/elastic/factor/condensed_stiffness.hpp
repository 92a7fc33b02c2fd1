// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/base/progress.hpp"
#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/factor/precision.hpp"

namespace ffcontact {

/// The stiffness of a body seen from a few kept dofs c (those of the contact line), by
/// one sparse factorisation.
///
/// With the kept dofs c ordered last the factorisation stops before them,
///     K = L [I 0; 0 S] L',    L = [L_ii 0; K_ci L_ii'^-1 I],
/// and leaves Schur's complement S = K_cc - K_ci K_ii^-1 K_ic. Bodies that only contact
/// holds are factored like others: S is singular then, and keeps exactly their rigid
/// motions. What is factored is R K R with R = diag(K)^-1/2: units, and materials or
/// triangles that differ by any factor, do not count as singular. The interior is ordered
/// by METIS on the graph of vertices, not of dofs.
///
/// In single precision it takes half the time and half the memory, and is that of a matrix
/// that differs from K by rounding: what it gives is corrected by the residuals of K
/// itself (solve_contact of surfaces, Rebalancing).
///
/// Several processes may hold the factor: who knows how to ask them derives from this.
class CondensedStiffness {
 public:
  /// A load after elimination of the interior, for one use of the factor's first half.
  struct Load {
    VectorXd eliminated;  ///< L^-1 R b [free dofs, as they are eliminated]
    VectorXd on_kept;     ///< g = b_c - K_ci K_ii^-1 b_i [kept]
  };

  /// @param kept  free dofs to keep, without repetition; the order is that of all vectors
  ///              and matrices of kept dofs
  /// @param report  as that of PartialCholesky
  /// @throws std::invalid_argument  if a kept dof is prescribed or out of range, or by
  ///                                require_room_for_schur
  /// @throws std::runtime_error     if K_ii is not positive definite: a part of the body
  ///                                is held by nothing, or, in single precision, nearly
  CondensedStiffness(const ElasticSystem& system, const std::vector<int>& kept,
                     Precision precision = Precision::full,
                     const ProgressReport& report = {});
  virtual ~CondensedStiffness();
  CondensedStiffness(CondensedStiffness&&) noexcept;
  CondensedStiffness& operator=(CondensedStiffness&&) noexcept;

  virtual Precision precision() const;

  /// Are systems with it solved to rounding? Others are corrected.
  bool is_exact() const { return precision() == Precision::full; }

  /// S [kept x kept].
  virtual const MatrixXd& schur() const;

  /// For a load on all dofs. The solution obeys S u_c = g + contact forces.
  virtual Load condensed(const Ref<const VectorXd>& load) const;

  /// The displacement on all dofs (0 on prescribed ones) that has u_c on the kept dofs
  /// and balances the load on the others.
  virtual VectorXd extended(Load load,
                            const Ref<const VectorXd>& kept_displacement) const;

 protected:
  CondensedStiffness();  ///< whose factor is elsewhere

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace ffcontact
