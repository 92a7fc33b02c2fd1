// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/law/compliant_layer.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact {

void require_valid(const CompliantLayer& layer) {
  require_nonnegative("compliance", Vector2d(layer.normal, layer.tangential));
}

VectorXd nodal_compliance(const CompliantLayer& layer, const VectorXd& area,
                          int dimension, const Flags& held) {
  VectorXd rows(dimension * area.size());
  for (Index row = 0; row < rows.size(); ++row)
    rows[row] = layer.of(row % dimension) / area[row / dimension];
  return without(held, std::move(rows));
}

}  // namespace ffcontact
