// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/tractions/rebalancing.hpp"

#include <algorithm>
#include <utility>

#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

Rebalancing::Rebalancing(const ElasticSystem& system,
                         const std::vector<int>& contact_dofs,
                         const MatrixXd& motions,
                         std::shared_ptr<const CondensedStiffness> stiffness)
    : system_(system),
      contact_dofs_(contact_dofs),
      motions_(motions),
      stiffness_(stiffness ? std::move(stiffness)
                           : std::make_shared<const CondensedStiffness>(
                                 system, contact_dofs)) {
  schur_.emplace(system, contact_dofs, *stiffness_,
                 motions(contact_dofs, Eigen::all));
}

Rebalancing::Rebalancing(const ElasticSystem& system,
                         const std::vector<int>& contact_dofs,
                         const MatrixXd& motions, LinearMap inverse,
                         double enough)
    : system_(system),
      contact_dofs_(contact_dofs),
      motions_(motions),
      inverse_(std::move(inverse)),
      enough_(enough) {}

VectorXd Rebalancing::solved(const VectorXd& force_change) const {
  if (!stiffness_) return without_motion(inverse_(force_change));
  CondensedStiffness::Load load = stiffness_->condensed(force_change);
  const VectorXd kept = schur_->solve(load.on_kept);
  return stiffness_->extended(std::move(load), kept);
}

VectorXd Rebalancing::without_motion(VectorXd u) const {
  if (motions_.cols() == 0) return u;
  const MatrixXd on_contact = motions_(contact_dofs_, Eigen::all);
  return u - motions_ * least_squares(on_contact, u(contact_dofs_));
}

VectorXd Rebalancing::displacement(const VectorXd& force_change) const {
  constexpr int most_corrections = 10;
  constexpr double of_rounding = 1e-14, least_gain = 4;
  VectorXd u = solved(force_change);
  if (stiffness_ && stiffness_->is_exact()) return u;
  double last = max_norm(force_change);
  const double rounding = of_rounding * last,
               wanted = std::max(rounding, enough_);
  for (int k = 0; k < most_corrections; ++k) {
    const VectorXd left =
        on_free_dofs(system_, force_change - system_.stiffness * u);
    const double size = max_norm(left);
    if (size <= wanted) return u;
    if (!(size * least_gain <= last)) break;
    u += solved(left);
    last = size;
  }
  if (last <= 1e3 * rounding) return u;
  return Rebalancing(system_, contact_dofs_, motions_)
      .displacement(force_change);
}

}  // namespace ffcontact
