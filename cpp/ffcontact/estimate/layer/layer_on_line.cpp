// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

namespace ffcontact {

SpringNorms layer_norms(const ContactLine& line, const ContactLaw<2>& law,
                        const ContactDensities& densities) {
  SpringNorms norms;
  if (!law.layer.given()) return norms;
  norms.difference.resize(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Matrix2d p = law.carried(Eigen::all, line.edge_node.col(e)),
                   r = end_values(densities, e).reshaped(2, 2), off = r - p,
                   both = r + p;
    norms.difference[e] = line.length[e] * layer_product(law.layer, off, off);
    norms.sum += line.length[e] * layer_product(law.layer, both, both);
  }
  return norms;
}

}  // namespace ffcontact
