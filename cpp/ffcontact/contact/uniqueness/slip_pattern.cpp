// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/slip_pattern.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Of the bound and of the largest values, below which a difference is that of a solver.
constexpr double tolerance = 1e-6;

/// Nodes without a sign take that of the node before, those before the first one its own.
void fill_signs(VectorXd& sign) {
  const auto first =
      std::find_if(sign.begin(), sign.end(), [](double s) { return s != 0; });
  double last = first == sign.end() ? 1 : *first;
  for (double& s : sign) last = s = s != 0 ? s : last;
}

double sign_above(double value, double threshold) {
  return std::abs(value) > threshold ? std::copysign(1.0, value) : 0;
}

}  // namespace

VectorXd SlipPattern::weight(double largest_friction) const {
  if (largest_friction == 0) return VectorXd::Zero(sign.size());
  return sign.cwiseProduct(slope) / largest_friction;
}

double largest_friction(const NodalLaw& law) {
  double largest = 0;
  for (const FrictionCone& cone : law.cone)
    largest = std::max(largest, cone.friction);
  return largest;
}

SlipPattern slip_pattern(const NodalLaw& law,
                         const Ref<const Matrix2Xd>& multiplier,
                         const Ref<const Matrix2Xd>& force,
                         const Ref<const VectorXd>& slip) {
  const Index nodes = law.node_count();
  SlipPattern pattern{VectorXd(nodes), VectorXd(nodes), Flags(nodes), false};
  const double least_P = tolerance * max_norm(multiplier),
               least_force = tolerance * max_norm(force),
               least_slip = tolerance * max_norm(slip);
  for (Index i = 0; i < nodes; ++i) {
    const FrictionCone& cone = law.cone[i];
    const double Pn = multiplier(0, i), Pt = multiplier(1, i);
    const bool sticks =
        cone.bonded ||
        (-Pn > least_P && std::abs(Pt) < (1 - tolerance) * cone.bound(Pn));
    const double against = sticks ? -sign_above(force(1, i), least_force)
                                  : -sign_above(Pt, least_P);
    pattern.sign[i] = against != 0 ? against : sign_above(slip[i], least_slip);
    pattern.slope[i] = cone.at_limit(Pn) ? 0 : cone.friction;
    pattern.reaches_limit = pattern.reaches_limit || cone.at_limit(Pn);
    pattern.sticks[i] = sticks;
  }
  fill_signs(pattern.sign);
  return pattern;
}

}  // namespace ffcontact
