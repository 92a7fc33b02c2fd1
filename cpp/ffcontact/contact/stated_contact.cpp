// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/stated_contact.hpp"

#include <algorithm>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/contact/law/nodal_pressures.hpp"
#include "ffcontact/interface/nodal_force.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

/// W of the values.
template <int d>
VectorXd StatedContact<d>::weighted(const NodalVectors& values) const {
  if constexpr (d == 2)
    return weight_of_rows(law.multiplier, contact) * values.reshaped();
  else
    return values.reshaped();
}

template <int d>
typename StatedContact<d>::NodalVectors StatedContact<d>::forces_of(
    const VectorXd& P) const {
  return weighted(P.reshaped(d, contact.node_count()))
      .reshaped(d, contact.node_count());
}

template <int d>
VectorXd StatedContact<d>::load_of(const VectorXd& P) const {
  return nodal_load(contact, without<NodalVectors>(held.row, forces_of(P)),
                    system.dof_count());
}

/// On a layer that carries the multipliers, which are forces then.
template <int d>
ContactLaw<d> StatedContact<d>::law_under(const VectorXd& P) const {
  if (!law.layer.given()) return law;
  return on_layer(law, lumped_pressures(contact, without<NodalVectors>(
                                                     held.row, forces_of(P))));
}

template <int d>
VectorXd StatedContact<d>::v_of(const VectorXd& displacement,
                                const VectorXd& P) const {
  return weighted(
      steered_displacement(contact, law_under(P), held, displacement));
}

/// Nodes whose friction loads nothing. Pressures load what is beside them, too.
template <int d>
Flags StatedContact<d>::idle() const {
  Flags idle(contact.node_count(), 0);
  if constexpr (d == 2)
    if (law.multiplier == Multiplier::pressure) return idle;
  for (int i = 0; i < contact.node_count(); ++i)
    idle[i] = std::all_of(held.row.begin() + d * i + 1,
                          held.row.begin() + d * (i + 1),
                          [](auto held) { return held != 0; });
  return idle;
}

/// Of a row of W.
template <int d>
double StatedContact<d>::largest_weight() const {
  if constexpr (d == 2) {
    const VectorXd ones = VectorXd::Ones(contact.node_count());
    return max_norm(weight_matrix(law.multiplier, contact) * ones);
  }
  return 1;
}

template <int d>
double StatedContact<d>::law_defect(const VectorXd& displacement,
                                    const VectorXd& P,
                                    const LawScales& least) const {
  const double scale =
      largest_weight() * largest_displacement(law_under(P), displacement);
  return law_violation(cones, P, v_of(displacement, P),
                       {std::max(least.v, scale), least.P}, idle());
}

template struct StatedContact<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
