// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

namespace ffcontact {

namespace {

void add(const Vector4d& moments, int edge, BoundaryTractions& boundary) {
  boundary.known.col(edge).setConstant(true);
  boundary.moments.col(edge) += moments;
}

}  // namespace

Vector4d reversed(const Vector4d& moments) {
  return {-moments[2], -moments[3], -moments[0], -moments[1]};
}

std::vector<int> contact_edge_numbers(const ContactLine& line,
                                      const Edges& edges) {
  std::vector<int> numbers(edges.count(), -1);
  for (int e = 0; e < line.edge_count(); ++e) {
    numbers[line.edge[e]] = e;
    const int facing = facing_edge(line, e);
    if (facing >= 0) numbers[facing] = e;
  }
  return numbers;
}

Matrix4d moments_of_ends(const ContactLine& line, int contact_edge) {
  const double length = line.length[contact_edge];
  const Vector2i nodes = line.edge_node.col(contact_edge);
  const Matrix2d frames = line.frame(nodes[0]) + line.frame(nodes[1]);
  Matrix4d moments = (length / 12 * frames).replicate<2, 2>();
  for (int k = 0; k < 2; ++k)
    moments.block<2, 2>(2 * k, 2 * k) += length / 6 * line.frame(nodes[k]);
  return moments;
}

Vector4d contact_moments(const ContactLine& line,
                         const ContactDensities& densities, int contact_edge) {
  return moments_of_ends(line, contact_edge) *
         end_values(densities, contact_edge);
}

BoundaryTractions boundary_tractions(const Mesh& mesh, const Edges& edges,
                                     const Flags& prescribed,
                                     const Ref<const Matrix4Xd>& neumann,
                                     const ContactLine& line,
                                     const ContactDensities& contact) {
  BoundaryTractions boundary =
      given_tractions(mesh, edges, prescribed, neumann);
  for (int k = 0; k < line.edge_count(); ++k) {
    const Vector4d moments = contact_moments(line, contact, k);
    add(moments, line.edge[k], boundary);
    const int facing = facing_edge(line, k);
    if (facing >= 0) add(reversed(moments), facing, boundary);
  }
  return boundary;
}

}  // namespace ffcontact
