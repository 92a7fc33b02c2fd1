// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/rebalancing.hpp"

#include "ffcontact/contact/condensed_contact.hpp"

namespace ffcontact {

Rebalancing::Rebalancing(const ElasticSystem& system, const ContactLine& line,
                         const MatrixXd& motions,
                         std::shared_ptr<const CondensedStiffness> stiffness)
    : stiffness_(std::move(stiffness)) {
  const std::vector<int> kept = contact_dofs(line, system);
  if (!stiffness_) stiffness_ = std::make_shared<const CondensedStiffness>(system, kept);
  const MatrixXd Z = motions(kept, Eigen::all);
  const double scale = stiffness_->schur().diagonal().mean();
  const MatrixXd S = stiffness_->schur() + scale * Z * Z.transpose();
  schur_ = Cholesky(S);
}

VectorXd Rebalancing::displacement(const VectorXd& force_change) const {
  return stiffness_->extended(force_change,
                              schur_.solve(stiffness_->condensed_load(force_change)));
}

}  // namespace ffcontact
