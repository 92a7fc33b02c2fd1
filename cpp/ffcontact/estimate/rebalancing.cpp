// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/rebalancing.hpp"

namespace ffcontact {

namespace {

/// S + s Z Z' with s of the size of S: regular where contact alone holds the motions Z.
MatrixXd with_motions(const MatrixXd& S, const MatrixXd& Z) {
  MatrixXd regular = S;
  if (Z.cols() > 0) regular += S.diagonal().mean() * Z * Z.transpose();
  return regular;
}

}  // namespace

Rebalancing::Rebalancing(const ElasticSystem& system,
                         const std::vector<int>& contact_dofs,
                         const MatrixXd& motions,
                         std::shared_ptr<const CondensedStiffness> stiffness)
    : stiffness_(std::move(stiffness)) {
  if (!stiffness_)
    stiffness_ =
        std::make_shared<const CondensedStiffness>(system, contact_dofs);
  const MatrixXd Z = motions(contact_dofs, Eigen::all);
  schur_ = DenseCholesky(with_motions(stiffness_->schur(), Z));
}

VectorXd Rebalancing::displacement(const VectorXd& force_change) const {
  CondensedStiffness::Load load = stiffness_->condensed(force_change);
  const VectorXd kept = schur_.solve(load.on_kept);
  return stiffness_->extended(std::move(load), kept);
}

}  // namespace ffcontact
