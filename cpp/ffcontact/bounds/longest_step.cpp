// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/bounds/longest_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ffcontact {

namespace {

/// l' diag(K)^-1 l
double energy_of_hats(const ElasticSystem& system, const VectorXd& l) {
  const Eigen::ArrayXd K = system.stiffness.diagonal();
  return (K > 0).select(l.array().square() / K, 0).sum();
}

/// The energy under l alone of bodies whose contact does not move; 0 where there is no
/// factor to know it by.
double held_energy(const CondensedStiffness* stiffness, const VectorXd& l) {
  if (!stiffness) return 0;
  auto load = stiffness->condensed(l);
  const VectorXd held = VectorXd::Zero(load.on_kept.size());
  return l.dot(stiffness->extended(std::move(load), held));
}

}  // namespace

double longest_step(const ElasticSystem& system,
                    const CondensedStiffness* stiffness, const VectorXd& l,
                    double stress) {
  const double longest = 6 * stress / std::sqrt(energy_of_hats(system, l)),
               held = std::sqrt(std::max(0.0, held_energy(stiffness, l)));
  return 2 * stress < longest * held ? 2 * stress / held : longest;
}

}  // namespace ffcontact
