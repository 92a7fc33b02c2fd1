// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/contact_law.hpp"

#include <algorithm>

#include "ffcontact/base/require.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Nothing, or a coefficient of each node.
void require_coefficient(const char* name, const VectorXd& values, int nodes) {
  if (values.size() == 0) return;
  require_size(name, values.size(), nodes);
  require_nonnegative(name, values);
}

/// Nothing, or finite components at each node.
void require_given(const char* name, const Ref<const MatrixXd>& components,
                   int nodes) {
  if (components.size() == 0) return;
  require_size(name, components.cols(), nodes);
  require_finite(name, components.reshaped());
}

template <int d>
void require_of_line(const ContactLaw<d>& law, int edges) {
  if (law.layer.given() && law.multiplier == Multiplier::pressure)
    refuse("compliance= is for nodal forces: leave multiplier= out");
  require_valid("the coefficient between the nodes", law.between_nodes, edges);
  require_valid("the shear limit between the nodes", law.limit_between_nodes,
                edges);
}

}  // namespace

template <int d>
void require_valid(const ContactLaw<d>& law, const LineOrSurface<d>& where) {
  const int nodes = where.node_count();
  require_valid(law.layer);
  require_size("friction", law.friction.size(), nodes);
  require_nonnegative("friction", law.friction);
  require_coefficient("slipbound", law.slip_bound, nodes);
  require_coefficient("shear limit", law.shear_limit, nodes);
  if (law.limited() && law.tresca())
    refuse("a shear limit belongs to Coulomb's law, not to Tresca's");
  require_given("gap", law.gap.transpose(), nodes);
  require_given("previous tangential displacement", law.previous, nodes);
  if (!law.bonded.empty())
    require_size("bonded", static_cast<Index>(law.bonded.size()), nodes);
  if constexpr (d == 2) require_of_line(law, where.edge_count());
}

template <int d>
ContactLaw<d> on_layer(
    ContactLaw<d> law,
    const Ref<const typename ContactLaw<d>::NodalVectors>& traction) {
  if (!law.layer.given()) return law;
  law.carried = traction;
  const Matrix<double, d, Dynamic> moved = law.layer.given_way(law.carried);
  law.gap = beyond<VectorXd>(law.gap, moved.row(0).transpose());
  law.previous = beyond<Matrix<double, d - 1, Dynamic>>(
      law.previous, moved.template bottomRows<d - 1>());
  return law;
}

template <int d>
typename ContactLaw<d>::NodalVectors displacement_against_foundation(
    const LineOrSurface<d>& where, const ContactLaw<d>& law,
    const Ref<const VectorXd>& displacement) {
  Matrix<double, d, Dynamic> v = contact_components(where, displacement);
  if (law.gap.size() > 0) v.row(0) -= law.gap.transpose();
  if (law.previous.size() > 0) v.template bottomRows<d - 1>() -= law.previous;
  return v;
}

template <int d>
double largest_given(const ContactLaw<d>& law) {
  return std::max(max_norm(law.gap), max_norm(law.previous));
}

template <int d>
double largest_displacement(const ContactLaw<d>& law,
                            const Ref<const VectorXd>& displacement) {
  return std::max(max_norm(displacement), largest_given(law));
}

template void require_valid(const ContactLaw<FFCONTACT_DIMENSION>&,
                            const LineOrSurface<FFCONTACT_DIMENSION>&);
template ContactLaw<FFCONTACT_DIMENSION> on_layer(
    ContactLaw<FFCONTACT_DIMENSION>,
    const Ref<const ContactLaw<FFCONTACT_DIMENSION>::NodalVectors>&);
template ContactLaw<FFCONTACT_DIMENSION>::NodalVectors
displacement_against_foundation(const LineOrSurface<FFCONTACT_DIMENSION>&,
                                const ContactLaw<FFCONTACT_DIMENSION>&,
                                const Ref<const VectorXd>&);
template double largest_given(const ContactLaw<FFCONTACT_DIMENSION>&);
template double largest_displacement(const ContactLaw<FFCONTACT_DIMENSION>&,
                                     const Ref<const VectorXd>&);

}  // namespace ffcontact
