// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ffcontact/elastic/factor/schur_solver.hpp"
#include "ffcontact/linear/iterative/krylov.hpp"

namespace ffcontact {

/// u* - u_h where K u* = b + (nodal forces of r_hat) and K u_h = b + (nodal forces of
/// lambda_h): the displacement whose stresses are in equilibrium with r_hat.
///
/// Where K is singular (rigid motions Z that contact alone holds) the change of forces
/// does no work on Z, and the solution without rigid motion on the contact dofs is taken
/// (SchurSolver). The same balances any other small change of the nodal forces, as the
/// rounding of u_h leaves. What a factor in single precision gives, or multigrid, is
/// corrected by the residuals of K itself, and where that fails a factor is made in full.
class Rebalancing {
 public:
  /// @param contact_dofs  the free dofs of the contact line or surface
  /// @param motions       free_rigid_motions of the body [dofs x k]
  /// @param stiffness     K condensed to contact_dofs; null: factorised here
  /// @throws std::runtime_error  if a part of the body is held by nothing
  Rebalancing(const ElasticSystem& system, const std::vector<int>& contact_dofs,
              const MatrixXd& motions,
              std::shared_ptr<const CondensedStiffness> stiffness = nullptr);

  /// @param inverse  near that of K, as multigrid_inverse, in place of a factor
  /// @param enough   largest residual that may be left, beyond rounding [N]
  Rebalancing(const ElasticSystem& system, const std::vector<int>& contact_dofs,
              const MatrixXd& motions, LinearMap inverse, double enough = 0);

  /// u* - u_h on all dofs [mm], by one back-substitution, or some in single precision.
  /// @param force_change  on all dofs [N/mm]
  VectorXd displacement(const VectorXd& force_change) const;

 private:
  VectorXd solved(const VectorXd& force_change) const;
  /// On the contact dofs.
  VectorXd without_motion(VectorXd u) const;

  const ElasticSystem& system_;  ///< of the caller
  std::vector<int> contact_dofs_;
  MatrixXd motions_;
  std::shared_ptr<const CondensedStiffness> stiffness_;
  std::optional<SchurSolver> schur_;
  LinearMap inverse_;
  double enough_ = 0;
};

}  // namespace ffcontact
