// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

#include <algorithm>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// |E| sigma grad phi_i on each triangle of the star of vertex i.
Matrix2Xd star_forces(const Topology& topology, int vertex,
                      const Ref<const Matrix3Xd>& stress) {
  const auto& [mesh, edges, stars] = topology;
  Matrix2Xd forces(2, stars.triangle_count(vertex));
  for (int k = 0; k < forces.cols(); ++k) {
    const int place = stars.triangle_start[vertex] + k;
    const int t = stars.triangle[place];
    const Vector2d gradient = hat_gradients(mesh, t).col(stars.local[place]);
    forces.col(k) = signed_area(mesh, t) * traction(stress.col(t), gradient);
  }
  return forces;
}

/// Whether one of the edges beside a boundary vertex leaves a component free.
bool is_supported(const Stars& stars, int vertex, int component,
                  const BoundaryTractions& boundary) {
  if (!stars.on_boundary(vertex)) return false;
  const auto [first, last] = end_spokes(stars, vertex);
  return !boundary.known(component, first) || !boundary.known(component, last);
}

/// Forces of the boundary tractions beside a vertex.
Vector2d boundary_forces(const Topology& topology, int vertex,
                         const BoundaryTractions& boundary) {
  if (!topology.stars.on_boundary(vertex)) return Vector2d::Zero();
  const auto [first, last] = end_spokes(topology.stars, vertex);
  return moment_at(topology.edges, boundary.moments, first, vertex) -
         moment_at(topology.edges, boundary.moments, last, vertex);
}

/// Adds a force on a vertex where no support answers.
void add_force(const Vector2d& force, int vertex, NodalResidual& residual) {
  for (int c = 0; c < 2; ++c)
    if (!residual.supported(c, vertex)) residual.missing(c, vertex) += force[c];
}

/// NodalResidual::supported
Eigen::Array<bool, 2, Dynamic> supported_components(
    const Topology& topology, const BoundaryTractions& boundary) {
  Eigen::Array<bool, 2, Dynamic> supported(2, topology.mesh.vertices.cols());
  for (int v = 0; v < supported.cols(); ++v)
    for (int c = 0; c < 2; ++c)
      supported(c, v) = is_supported(topology.stars, v, c, boundary);
  return supported;
}

}  // namespace

EndSpokes end_spokes(const Stars& stars, int vertex) {
  return {stars.spoke[stars.spoke_start[vertex]],
          stars.spoke[stars.spoke_start[vertex + 1] - 1]};
}

Vector2d moment_at(const Edges& edges, const EdgeMoments& moments, int spoke,
                   int vertex) {
  const Vector4d along_edge = moments.col(spoke);
  const bool starts_here = edges.vertices(0, spoke) == vertex;
  return (starts_here ? along_edge : reversed(along_edge)).head<2>();
}

Matrix2Xd star_loads(const Topology& topology, int vertex,
                     const Ref<const Matrix3Xd>& stress,
                     const BodyLoadsOfAll& body_loads) {
  const Stars& stars = topology.stars;
  Matrix2Xd loads = star_forces(topology, vertex, stress);
  for (int k = 0; k < loads.cols(); ++k) {
    const int place = stars.triangle_start[vertex] + k;
    const int t = stars.triangle[place], local = stars.local[place];
    loads.col(k) -= body_loads.block<2, 1>(2 * local, t);
  }
  return loads;
}

NodalResidual nodal_residual(const Topology& topology,
                             const Ref<const Matrix3Xd>& stress,
                             const BodyLoadsOfAll& body_loads,
                             const BoundaryTractions& boundary) {
  const int vertices = topology.mesh.vertex_count();
  NodalResidual residual{Matrix2Xd::Zero(2, vertices),
                         supported_components(topology, boundary), 0};
  double scale = max_norm(boundary.moments);
#pragma omp parallel for reduction(max : scale)
  for (int v = 0; v < vertices; ++v) {
    if (topology.stars.triangle_count(v) == 0) continue;
    const Matrix2Xd loads = star_loads(topology, v, stress, body_loads);
    scale = std::max(scale, max_norm(loads));
    add_force(boundary_forces(topology, v, boundary) - loads.rowwise().sum(), v,
              residual);
  }
  residual.scale = scale;
  return residual;
}

NodalResidual with_forces(NodalResidual residual, const VectorXd& forces) {
  const Matrix2Xd added = forces.reshaped(2, residual.missing.cols());
  residual.missing += residual.supported.select(0, added);
  residual.scale = std::max(residual.scale, max_norm(forces));
  return residual;
}

NodalResidual less_stress(const Topology& topology, NodalResidual residual,
                          const Ref<const Matrix3Xd>& added) {
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v) {
    if (topology.stars.triangle_count(v) == 0) continue;
    const Vector2d sum = star_forces(topology, v, added).rowwise().sum();
    add_force(-sum, v, residual);
  }
  return residual;
}

}  // namespace ffcontact
