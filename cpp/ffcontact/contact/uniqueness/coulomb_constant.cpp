// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/uniqueness/coulomb_constant.hpp"

#include <cmath>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/uniqueness/slip_forms.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

double coulomb_constant(const CondensedContact& contact,
                        const SlipPattern& pattern, double largest_friction,
                        StuckNodes stuck) {
  if (pattern.reaches_limit && stuck == StuckNodes::may_slip) return infinity;
  const VectorXd weight = pattern.weight(largest_friction);
  if (weight.isZero(0)) return 0;
  const Flags none(pattern.sticks.size(), 0);
  const std::optional<SlipForms> forms =
      SlipForms::of(contact, weight.transpose(),
                    stuck == StuckNodes::stick ? pattern.sticks : none);
  return forms ? forms->largest_ratio() : infinity;
}

double coulomb_bound(double e, double largest_friction, double kappa,
                     double missed) {
  if (largest_friction == 0 || (kappa == 0 && missed == 0)) return e;
  const double rest = 1 - largest_friction * kappa;
  if (!(rest > 0)) return infinity;
  return (missed + std::hypot(missed, std::sqrt(rest) * e)) / rest;
}

}  // namespace ffcontact
