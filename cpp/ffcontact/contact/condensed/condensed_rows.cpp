// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/condensed/condensed_rows.hpp"

#include <algorithm>
#include <cmath>

#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// The larger S_ii of the components of the node of primary unknown i.
double stiffer_component(const CondensedContact& contact, Index i) {
  const int dim = contact.dimension, first = contact.primary[i] / dim * dim;
  double largest = 0;
  for (int row = first; row < first + dim; ++row)
    if (const int k = contact.position[row]; k >= 0)
      largest = std::max(largest, contact.S(k, k));
  return largest;
}

}  // namespace

UnknownScales unknown_scales(const CondensedContact& contact) {
  UnknownScales scales;
  scales.v = contact.S.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  scales.q.resize(contact.E.cols());
  for (Index d = 0; d < scales.q.size(); ++d) {
    const double reach =
        std::hypot(contact.E.col(d).cwiseProduct(scales.v).norm(),
                   std::sqrt(contact.F(d, d)));
    scales.q[d] = 1 / (reach > 0 ? reach : scales.v.mean());
  }
  return scales;
}

ContactRows rows_of(const CondensedContact& contact, const VectorXd& v,
                    const VectorXd& q) {
  const VectorXd P = contact.S * v - contact.g - contact.E * q;
  const VectorXd v_dependent =
      contact.E.transpose() * v + contact.F * q + contact.dependent_offset;
  const Index count = contact.position.size();
  ContactRows rows{VectorXd(count), VectorXd(count)};
  for (Index row = 0; row < count; ++row) {
    const int k = contact.position[row];
    rows.P[row] = k >= 0 ? P[k] : q[-1 - k];
    rows.v[row] = k >= 0 ? v[k] : v_dependent[-1 - k];
  }
  return rows;
}

VectorXd displacement_of(const CondensedContact& contact,
                         const CondensedStiffness& stiffness, const VectorXd& v,
                         const VectorXd& P) {
  return stiffness.extended(
      contact.load,
      kept_displacement(contact, v(contact.primary), P(contact.dependent)));
}

double motion_scale(const CondensedContact& contact, const VectorXd& v) {
  double scale = max_norm(v);
  for (Index i = 0; i < contact.g.size(); ++i) {
    const double stiffness = stiffer_component(contact, i);
    if (stiffness > 0)
      scale = std::max(scale, std::abs(contact.g[i]) / stiffness);
  }
  return scale;
}

}  // namespace ffcontact
