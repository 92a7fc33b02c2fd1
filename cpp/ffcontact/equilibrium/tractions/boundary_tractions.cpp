// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_tractions.hpp"

#include <array>

#include "ffcontact/base/entry_of.hpp"
#include "ffcontact/base/flags.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/tractions/prescribed_labels.hpp"

namespace ffcontact {

namespace {

using Components = std::array<bool, 2>;

void add(const Vector4d& moments, int edge, BoundaryTractions& boundary) {
  boundary.known.col(edge).setConstant(true);
  boundary.moments.col(edge) += moments;
}

/// What one boundary edge carries.
/// @param free     components that the support answers
/// @param neumann  moments along the column of Mesh::boundary
void put_edge(int edge, const Components& free, const Vector4d& neumann,
              bool same_direction, BoundaryTractions& given) {
  for (int c = 0; c < 2; ++c) {
    given.known(c, edge) = !free[c];
    if (free[c]) continue;
    given.moments(c, edge) = neumann[(same_direction ? 0 : 2) + c];
    given.moments(2 + c, edge) = neumann[(same_direction ? 2 : 0) + c];
  }
}

}  // namespace

Vector4d reversed(const Vector4d& moments) {
  return {-moments[2], -moments[3], -moments[0], -moments[1]};
}

BoundaryTractions given_tractions(const Mesh& mesh, const Edges& edges,
                                  const Flags& prescribed,
                                  const Ref<const Matrix4Xd>& neumann) {
  require_fitting(mesh, prescribed, neumann);
  const PrescribedLabels<2> fixed = prescribed_labels(mesh, prescribed);
  BoundaryTractions given;
  given.known.setConstant(2, edges.count(), false);
  given.moments = EdgeMoments::Zero(4, edges.count());
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int b = edges.boundary_index[e];
    const bool same_direction = mesh.boundary(0, b) == edges.vertices(0, e);
    put_edge(e, entry_of(fixed, mesh.boundary_label[b], "facet with a label"),
             neumann.col(b), same_direction, given);
  }
  return given;
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
