// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

#include "ffcontact/equilibrium/stress/facet_density.hpp"

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

Matrix2d edge_frame(const ContactLine& line, int contact_edge) {
  Matrix2d frame;
  frame << line.edge_normal(contact_edge).transpose(),
      line.edge_tangent(contact_edge).transpose();
  return frame;
}

Vector4d contact_moments(const ContactLine& line,
                         const ContactDensities& densities, int contact_edge) {
  const Matrix2d r = end_values(densities, contact_edge).reshaped(2, 2),
                 density = edge_frame(line, contact_edge).transpose() * r;
  return facet_moments_of<2>(density, line.length[contact_edge]).reshaped();
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
