// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/nodal_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ffcontact {

NodalLaw nodal_law(const ContactLaw& law, const ContactLine& line) {
  const auto in_units_of_P = [&](const VectorXd& pressure) -> VectorXd {
    return law.multiplier == Multiplier::force && pressure.size() > 0
               ? contact_mass(line) * pressure
               : pressure;
  };
  return {law.friction, in_units_of_P(law.slip_bound), in_units_of_P(law.shear_limit)};
}

NodalLaw with_given_slip_limit(const NodalLaw& law, const Ref<const VectorXd>& normal) {
  NodalLaw given{law.friction, VectorXd(normal.size()), {}};
  for (int i = 0; i < normal.size(); ++i) given.tresca_bound[i] = law.bound(i, normal[i]);
  return given;
}

double law_violation(const NodalLaw& law, const Ref<const VectorXd>& P,
                     const Ref<const VectorXd>& v, const LawScales& scales) {
  if (!P.allFinite() || !v.allFinite()) return std::numeric_limits<double>::infinity();
  const double p_scale = std::max(scales.P, P.cwiseAbs().maxCoeff());
  const auto relative = [](double value, double scale) {
    return scale > 0 ? value / scale : 0;
  };
  double largest = 0;
  for (int i = 0; 2 * i < P.size(); ++i) {
    const double Pn = relative(P[2 * i], p_scale), Pt = relative(P[2 * i + 1], p_scale);
    const double vn = relative(v[2 * i], scales.v), vt = relative(v[2 * i + 1], scales.v);
    const double bound =
        law.tresca() ? relative(law.tresca_bound[i], p_scale)
                     : std::min(-law.friction[i] * Pn, relative(law.limit(i), p_scale));
    const auto both = [](double P, double v) {
      return std::min(std::abs(P), std::abs(v));
    };
    largest = std::max({largest, Pn, vn, both(Pn, vn),       // (3.17)-(3.19)
                        std::abs(Pt) - bound,                // (3.20)
                        both(bound - std::abs(Pt), vt),      // (3.21)
                        Pt * vt > 0 ? both(Pt, vt) : 0.0});  // (3.22)
  }
  return largest;
}

void put_into_law(const NodalLaw& law, const std::vector<ContactState>& state,
                  VectorXd& P) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    double &Pn = P[2 * i], &Pt = P[2 * i + 1];
    Pn = std::min(Pn, 0.0);
    const double bound = law.bound(static_cast<int>(i), Pn);
    Pt = slip_sign(state[i]) != 0 ? -slip_sign(state[i]) * bound
                                  : std::clamp(Pt, -bound, bound);
  }
}

}  // namespace ffcontact
