// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "ffcontact/equilibrium/cone/facet_cone.hpp"

namespace ffcontact {

template <>
FacetCone<2> facet_cone(const ContactFacet<2>& edge, const Matrix2d& present,
                        double) {
  const EdgeCone cone = edge_cone(edge.cone);
  return {cone.C, cone.d.cwiseMin(cone.C * present.reshaped())};
}

template <>
double cone_violation(const ContactFacet<2>& edge, const Matrix2d& traction) {
  const EdgeCone cone = edge_cone(edge.cone);
  if (cone.d.size() == 0) return 0;
  const VectorXd missing = cone.d - cone.C * traction.reshaped();
  return std::max(missing.cwiseQuotient(cone.C.rowwise().norm()).maxCoeff(),
                  0.0);
}

}  // namespace ffcontact
