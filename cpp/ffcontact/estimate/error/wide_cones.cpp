// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/wide_cones.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/contact/law/bounded_friction.hpp"
#include "ffcontact/contact/law/friction_cone.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Coulomb's coefficient, the least along an edge; 0 of Tresca's law.
double least_friction(const ContactLine& line, const ContactLaw<2>& law,
                      int e) {
  if (law.tresca()) return 0;
  const Matrix2Xd& along = law.between_nodes.least;
  if (along.size() > 0) return along.col(e).minCoeff();
  return std::min(law.friction[line.edge_node(0, e)],
                  law.friction[line.edge_node(1, e)]);
}

/// The nearest r in a wide cone: what gives way is r_n, not r_t, which would by mu times as
/// much. An r_n below `least` is rounding, and is as small as the law allows, |r_t| / mu: e
/// would pay mu |w_t|, or the shear limit's, for it.
Vector2d in_wide_cone(double mu, double limit, const Vector2d& r,
                      double least) {
  const double tangential = std::clamp(r[1], -limit, limit),
               allowed = -std::abs(tangential) / mu;
  return {std::abs(r[0]) < least ? allowed : std::min(r[0], allowed),
          tangential};
}

/// |w_t| on an edge, where it has one sign.
double mean_slip(const ContactLine& line, const TractionCosts& costs, int e) {
  return max_norm(costs.tangential.col(e)) / line.length[e];
}

}  // namespace

void clamp_rounding(const ContactLine& line, const ContactLaw<2>& law,
                    ContactDensities& densities) {
  constexpr double rounding = 2e-11;
  const double least = rounding * largest_traction(densities);
  for (int e = 0; e < line.edge_count(); ++e) {
    Vector4d r = end_values(densities, e);
    const double mu = least_friction(line, law, e);
    if (mu > most_friction) {
      const auto [first, second] = least_cones(line, law, e);
      r << in_wide_cone(mu, first.limit, r.head<2>(), least),
          in_wide_cone(mu, second.limit, r.tail<2>(), least);
    } else {
      r = clamped_to_cone(line, law, e, r);
    }
    set_end_values(densities, e, r);
  }
}

bool stays_unloaded(const ContactLine& line, const ContactLaw<2>& law,
                    const Ref<const VectorXd>& displacement,
                    const ContactDensities& densities,
                    const TractionCosts& costs, int e) {
  return end_values(densities, e).isZero(0) &&
         outweighs_all_gains(least_friction(line, law, e),
                             mean_slip(line, costs, e), max_norm(displacement));
}

}  // namespace ffcontact
