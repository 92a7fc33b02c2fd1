// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/boundary_tractions.hpp"

#include <array>
#include <map>

#include "ffcontact/base/require.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"

namespace ffcontact {

namespace {

/// Per label: which components are prescribed at every vertex that carries it.
std::map<int, std::array<bool, 2>> prescribed_labels(
    const Mesh& mesh, const std::vector<char>& prescribed) {
  std::map<int, std::array<bool, 2>> labels;
  for (Index e = 0; e < mesh.boundary.cols(); ++e) {
    std::array<bool, 2>& fixed =
        labels
            .try_emplace(mesh.boundary_label[e],
                         std::array<bool, 2>{true, true})
            .first->second;
    for (int end = 0; end < 2; ++end)
      for (int c = 0; c < 2; ++c)
        if (!prescribed[2 * mesh.boundary(end, e) + c]) fixed[c] = false;
  }
  return labels;
}

void add(const Vector4d& moments, int edge, BoundaryTractions& boundary) {
  boundary.known.col(edge).setConstant(true);
  boundary.moments.col(edge) += moments;
}

/// On the edge that faces a contact edge, which runs the other way.
Vector4d opposite(const Vector4d& moments) {
  Vector4d turned;
  turned << -moments.tail<2>(), -moments.head<2>();
  return turned;
}

}  // namespace

BoundaryTractions given_tractions(const Mesh& mesh, const Edges& edges,
                                  const std::vector<char>& prescribed,
                                  const Ref<const Matrix4Xd>& neumann) {
  require_size("prescribed dofs", static_cast<Index>(prescribed.size()),
               2 * mesh.vertices.cols());
  require_size("tractions", neumann.cols(), mesh.boundary.cols());
  require_finite("traction", neumann.reshaped());

  const std::map<int, std::array<bool, 2>> fixed =
      prescribed_labels(mesh, prescribed);
  BoundaryTractions given;
  given.known.setConstant(2, edges.count(), false);
  given.moments = EdgeMoments::Zero(4, edges.count());
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int b = edges.boundary_index[e];
    const std::array<bool, 2>& prescribed_here =
        fixed.at(mesh.boundary_label[b]);
    const bool same_direction = mesh.boundary(0, b) == edges.vertices(0, e);
    for (int c = 0; c < 2; ++c) {
      given.known(c, e) = !prescribed_here[c];
      if (prescribed_here[c]) continue;
      given.moments(c, e) = neumann((same_direction ? 0 : 2) + c, b);
      given.moments(2 + c, e) = neumann((same_direction ? 2 : 0) + c, b);
    }
  }
  return given;
}

Vector4d contact_moments(const ContactLine& line,
                         const ContactDensities& densities, int contact_edge) {
  const Vector2d n = line.edge_normal(contact_edge),
                 t = line.edge_tangent(contact_edge);
  const Vector4d r = end_values(densities, contact_edge);
  Vector4d density;
  density << r[0] * n + r[1] * t, r[2] * n + r[3] * t;
  return moments_of_density(density, line.length[contact_edge]);
}

BoundaryTractions boundary_tractions(const Mesh& mesh, const Edges& edges,
                                     const std::vector<char>& prescribed,
                                     const Ref<const Matrix4Xd>& neumann,
                                     const ContactLine& line,
                                     const ContactDensities& contact) {
  BoundaryTractions boundary =
      given_tractions(mesh, edges, prescribed, neumann);
  for (int k = 0; k < line.edge_count(); ++k) {
    const Vector4d moments = contact_moments(line, contact, k);
    add(moments, line.edge[k], boundary);
    if (line.against_a_body() && line.opposite_edge[k] >= 0)
      add(opposite(moments), line.opposite_edge[k], boundary);
  }
  return boundary;
}

}  // namespace ffcontact
