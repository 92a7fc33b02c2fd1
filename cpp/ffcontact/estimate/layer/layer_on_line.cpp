// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/layer/layer_parts.hpp"

namespace ffcontact {

namespace {

/// int f^2 over the unit length of a function that is linear.
double square(const Vector2d& ends) {
  return (ends.squaredNorm() + ends[0] * ends[1]) / 3;
}

/// int c_n r_n^2 + c_t r_t^2 over the unit length, by (r_n, r_t) at both ends.
double square(const CompliantLayer& layer, const Matrix2d& r) {
  return layer.normal * square(r.row(0)) + layer.tangential * square(r.row(1));
}

}  // namespace

SpringNorms layer_norms(const ContactLine& line, const ContactLaw& law,
                        const ContactDensities& densities) {
  SpringNorms norms;
  if (!law.layer.given()) return norms;
  norms.difference.resize(line.edge_count());
  for (int e = 0; e < line.edge_count(); ++e) {
    const Matrix2d p = law.carried(Eigen::all, line.edge_node.col(e)),
                   r = end_values(densities, e).reshaped(2, 2);
    norms.difference[e] = line.length[e] * square(law.layer, r - p);
    norms.sum += line.length[e] * square(law.layer, r + p);
  }
  return norms;
}

}  // namespace ffcontact
