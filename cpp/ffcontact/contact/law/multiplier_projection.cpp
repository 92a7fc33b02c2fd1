// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/multiplier_projection.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/law/cones_of_law.hpp"
#include "ffcontact/contact/law/nodal_law.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"

namespace ffcontact {

namespace {

/// What turns nodal pressures into the multipliers of the law.
VectorXd weights(const ContactLine& line, const ContactLaw<2>& law) {
  return law.multiplier == Multiplier::pressure
             ? VectorXd::Ones(line.node_count())
             : nodal_lengths(line);
}

/// The law with the bound that g gives, in units of P.
NodalLaw law_of_step(const ContactLine& line, const ContactLaw<2>& law,
                     const VectorXd& given_pressure) {
  const NodalLaw nodal = nodal_law(law, line);
  if (given_pressure.size() == 0) return nodal;
  return with_given_slip_limit(nodal,
                               weights(line, law).cwiseProduct(given_pressure));
}

void require_fitting(const ContactLine& line,
                     const Ref<const Matrix2Xd>& pressure,
                     const Ref<const VectorXd>& given_pressure) {
  require_size("contact pressures", pressure.cols(), line.node_count());
  require_finite("contact pressure", pressure.reshaped());
  if (given_pressure.size() == 0) return;
  require_size("g", given_pressure.size(), line.node_count());
  require_finite("g", given_pressure);
}

/// Onto the cone, which is in units of weight p.
Vector2d projected(const FrictionCone& cone, double weight, Vector2d p) {
  p[0] = std::min(p[0], 0.0);
  const double bound = cone.bound(weight * p[0]) / weight;
  return {p[0], std::clamp(p[1], -bound, bound)};
}

}  // namespace

MultiplierProjection projected_multipliers(
    const ContactLine& line, const ContactLaw<2>& law,
    const Ref<const Matrix2Xd>& pressure,
    const Ref<const VectorXd>& given_pressure) {
  require_valid(law, line);
  require_fitting(line, pressure, given_pressure);
  const NodalLaw nodal = law_of_step(line, law, given_pressure);
  const VectorXd weight = weights(line, law);
  MultiplierProjection result{pressure, 0};
  for (int i = 0; i < line.node_count(); ++i) {
    result.pressure.col(i) =
        projected(nodal.cone[i], weight[i], pressure.col(i));
    if (result.pressure.col(i) != pressure.col(i)) ++result.outside;
  }
  return result;
}

}  // namespace ffcontact
