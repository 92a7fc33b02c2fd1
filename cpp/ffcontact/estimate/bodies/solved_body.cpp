// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/bodies/solved_body.hpp"

namespace ffcontact {

Matrix4Xd boundary_moments(const Mesh& mesh, const SolvedBody& body) {
  if (body.springs.empty()) return body.neumann;
  return body.neumann + spring_moments(mesh, body.springs, body.displacement);
}

}  // namespace ffcontact
