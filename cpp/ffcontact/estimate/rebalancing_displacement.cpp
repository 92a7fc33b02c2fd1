// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/rebalancing_displacement.hpp"

#include "ffcontact/base/cholesky.hpp"
#include "ffcontact/contact/condensed_contact.hpp"

namespace ffcontact {

VectorXd rebalancing_displacement(const ElasticSystem& system, const ContactLine& line,
                                  const VectorXd& force_change, const MatrixXd& motions) {
  return rebalancing_displacement(CondensedStiffness(system, contact_dofs(line, system)),
                                  system, line, force_change, motions);
}

VectorXd rebalancing_displacement(const CondensedStiffness& stiffness,
                                  const ElasticSystem& system, const ContactLine& line,
                                  const VectorXd& force_change, const MatrixXd& motions) {
  const std::vector<int> kept = contact_dofs(line, system);
  const auto size = static_cast<Index>(kept.size());
  MatrixXd Z(size, motions.cols());
  for (Index k = 0; k < size; ++k) Z.row(k) = motions.row(kept[k]);
  const double scale = stiffness.schur().diagonal().mean();
  const MatrixXd S = stiffness.schur() + scale * Z * Z.transpose();
  return stiffness.extended(force_change,
                            Cholesky(S).solve(stiffness.condensed_load(force_change)));
}

}  // namespace ffcontact
