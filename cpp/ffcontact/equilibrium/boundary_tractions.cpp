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
        labels.try_emplace(mesh.boundary_label[e], std::array<bool, 2>{true, true})
            .first->second;
    for (int end = 0; end < 2; ++end)
      for (int c = 0; c < 2; ++c)
        if (!prescribed[2 * mesh.boundary(end, e) + c]) fixed[c] = false;
  }
  return labels;
}

}  // namespace

BoundaryTractions boundary_tractions(const Mesh& mesh, const Edges& edges,
                                     const std::vector<char>& prescribed,
                                     const Ref<const Matrix4Xd>& neumann,
                                     const ContactLine& line,
                                     const ContactDensities& contact) {
  require_size("prescribed dofs", static_cast<Index>(prescribed.size()),
               2 * mesh.vertices.cols());
  require_size("tractions", neumann.cols(), mesh.boundary.cols());
  require_finite("traction", neumann.reshaped());

  const std::map<int, std::array<bool, 2>> fixed = prescribed_labels(mesh, prescribed);
  BoundaryTractions result;
  result.known.setConstant(2, edges.count(), false);
  result.moments = EdgeMoments::Zero(4, edges.count());
  for (int e = 0; e < edges.count(); ++e) {
    if (!edges.on_boundary(e)) continue;
    const int b = edges.boundary_index[e];
    const std::array<bool, 2>& prescribed_here = fixed.at(mesh.boundary_label[b]);
    const bool same_direction = mesh.boundary(0, b) == edges.vertices(0, e);
    for (int c = 0; c < 2; ++c) {
      result.known(c, e) = !prescribed_here[c];
      if (prescribed_here[c]) continue;
      result.moments(c, e) = neumann((same_direction ? 0 : 2) + c, b);
      result.moments(2 + c, e) = neumann((same_direction ? 2 : 0) + c, b);
    }
  }
  for (int k = 0; k < line.edge_count(); ++k) {
    const Vector2d n = line.edge_normal(k), t = line.edge_tangent(k);
    Vector4d density;
    density << contact.normal(0, k) * n + contact.tangential(0, k) * t,
        contact.normal(1, k) * n + contact.tangential(1, k) * t;
    const Vector4d moments = moments_of_density(density, line.length[k]);
    const auto load = [&](int edge, const Vector4d& contact_moments) {
      result.known.col(edge).setConstant(true);
      result.moments.col(edge) += contact_moments;
    };
    load(line.edge[k], moments);
    if (!line.against_a_body() || line.opposite_edge[k] < 0) continue;
    Vector4d opposite;
    opposite << -moments.tail<2>(), -moments.head<2>();
    load(line.opposite_edge[k], opposite);
  }
  return result;
}

}  // namespace ffcontact
