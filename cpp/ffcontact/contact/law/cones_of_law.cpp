// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/cones_of_law.hpp"

namespace ffcontact {

namespace {

/// Of a bound on tractions, or nothing.
template <int d>
VectorXd in_units_of_P(const VectorXd& bound, const ContactLaw<d>& law,
                       const LineOrSurface<d>& where) {
  if (bound.size() == 0) return bound;
  if constexpr (d == 3)
    return bound.cwiseProduct(where.area);
  else if (law.multiplier == Multiplier::force)
    return contact_mass(where) * bound;
  return bound;
}

template <int d>
std::vector<FrictionCone> cones_of(const ContactLaw<d>& law,
                                   const VectorXd& slip_bound,
                                   const VectorXd& shear_limit) {
  std::vector<FrictionCone> cones(
      (law.tresca() ? slip_bound : law.friction).size());
  for (std::size_t i = 0; i < cones.size(); ++i) {
    FrictionCone& cone = cones[i];
    if (law.tresca())
      cone.cohesion = slip_bound[i];
    else
      cone.friction = law.friction[i];
    if (law.limited()) cone.limit = shear_limit[i];
    cone.bonded = law.is_bonded(static_cast<int>(i));
  }
  return cones;
}

}  // namespace

template <int d>
std::vector<FrictionCone> law_cones(const ContactLaw<d>& law) {
  return cones_of(law, law.slip_bound, law.shear_limit);
}

template <int d>
NodalLaw nodal_law(const ContactLaw<d>& law, const LineOrSurface<d>& where) {
  return {cones_of(law, in_units_of_P(law.slip_bound, law, where),
                   in_units_of_P(law.shear_limit, law, where))};
}

template std::vector<FrictionCone> law_cones(
    const ContactLaw<FFCONTACT_DIMENSION>&);
template NodalLaw nodal_law(const ContactLaw<FFCONTACT_DIMENSION>&,
                            const LineOrSurface<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
