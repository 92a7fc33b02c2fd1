// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

LinearStresses<2> total_stresses(const Mesh& mesh, const SolvedBody& body,
                                 const Ref<const VectorXd>& displacement) {
  return LinearStresses<2>(stresses(mesh, body.hooke, displacement)) +
         body.initial;
}

Matrix4Xd boundary_moments(const Mesh& mesh, const SolvedBody& body) {
  if (body.springs.empty()) return body.neumann;
  return body.neumann + spring_moments(mesh, body.springs, body.displacement);
}

}  // namespace ffcontact
