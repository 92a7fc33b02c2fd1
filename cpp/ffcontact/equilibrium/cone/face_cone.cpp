// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "ffcontact/equilibrium/cone/facet_cone.hpp"
#include "ffcontact/equilibrium/cone/inner_cone.hpp"

namespace ffcontact {

template <>
FacetCone<3> facet_cone(const ContactFacet<3>& face, const Matrix3d& present,
                        double largest) {
  constexpr Index most = 3 * InnerCone::most_rows;
  FacetCone<3> cone{Matrix<double, Dynamic, 9>::Zero(most, 9), VectorXd(most)};
  Index rows = 0;
  for (int i = 0; i < 3; ++i) {
    const InnerCone inner = inner_cone(face.cone[i], present.col(i),
                                       -face.direction.col(i), largest);
    const Index count = inner.d.size();
    cone.C.block(rows, 3 * i, count, 3) = inner.C;
    cone.least.segment(rows, count) = inner.d;
    rows += count;
  }
  cone.C.conservativeResize(rows, Eigen::NoChange);
  cone.least.conservativeResize(rows);
  return cone;
}

template <>
double cone_violation(const ContactFacet<3>& face, const Matrix3d& traction) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const double rt = traction.col(i).tail<2>().norm();
    largest = std::max(largest, face.cone[i].violation(traction(0, i), rt));
  }
  return largest;
}

}  // namespace ffcontact
