// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_moments.hpp"

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/nodal_residual.hpp"

namespace ffcontact {

namespace {

/// +1 when the spoke starts at the vertex.
double direction(const Edges& edges, int spoke, int vertex) {
  return edges.vertices(0, spoke) == vertex ? 1 : -1;
}

Vector3d mean_stress(const Edges& edges, int edge,
                     const Ref<const Matrix3Xd>& stress) {
  const int left = edges.cells(0, edge), right = edges.cells(1, edge);
  if (right < 0) return stress.col(left);
  return 0.5 * (stress.col(left) + stress.col(right));
}

/// The moments at a vertex that the mean stresses have on its spokes, seen along vertex
/// -> neighbour with the normal to the right.
Matrix2Xd mean_moments(const Topology& topology, int vertex,
                       const Ref<const Matrix3Xd>& stress) {
  const auto& [mesh, edges, stars] = topology;
  Matrix2Xd moments(2, stars.spoke_count(vertex));
  for (int k = 0; k < moments.cols(); ++k) {
    const int spoke = stars.spoke[stars.spoke_start[vertex] + k];
    const Vector2d turned = turned_right(edge_vector(mesh, edges, spoke));
    const Vector2d mean = traction(mean_stress(edges, spoke, stress), turned);
    moments.col(k) = 0.5 * direction(edges, spoke, vertex) * mean;
  }
  return moments;
}

/// Loads before each spoke: triangle k has moment(k) on its right side and moment(k + 1)
/// on its left, moment(k) - moment(k+1) = load(k), so that moment(k) = moment(0) -
/// sum(k).
Matrix2Xd sums_before(const Matrix2Xd& loads, int spokes) {
  Matrix2Xd sums = Matrix2Xd::Zero(2, spokes);
  for (int k = 0; k + 1 < spokes; ++k)
    sums.col(k + 1) = sums.col(k) + loads.col(k);
  return sums;
}

/// The moments of the spokes of one star.
void put_star(const Topology& topology, int vertex,
              const Ref<const Matrix3Xd>& stress,
              const BodyLoadsOfAll& body_loads,
              const BoundaryTractions& boundary, EdgeMoments& moments) {
  const auto& [mesh, edges, stars] = topology;
  const int* spokes = stars.spoke.data() + stars.spoke_start[vertex];
  const int count = stars.spoke_count(vertex), last = count - 1;
  const Matrix2Xd sum =
      sums_before(star_loads(topology, vertex, stress, body_loads), count);
  const Matrix2Xd mean = mean_moments(topology, vertex, stress);
  for (int c = 0; c < 2; ++c) {
    const auto given = [&](int k) {
      return moment_at(edges, boundary.moments, spokes[k], vertex, c);
    };
    const double start = boundary.known(c, spokes[0]) ? given(0)
                         : boundary.known(c, spokes[last])
                             ? given(last) + sum(c, last)
                             : (mean.row(c) + sum.row(c)).mean();
    for (int k = 0; k < count; ++k) {
      if (boundary.known(c, spokes[k])) continue;
      const double sign = direction(edges, spokes[k], vertex);
      moments((sign > 0 ? 0 : 2) + c, spokes[k]) = sign * (start - sum(c, k));
    }
  }
}

}  // namespace

EdgeMoments equilibrated_moments(const Topology& topology,
                                 const Ref<const Matrix3Xd>& stress,
                                 const BodyLoadsOfAll& body_loads,
                                 const BoundaryTractions& boundary) {
  EdgeMoments moments = boundary.moments;
#pragma omp parallel for
  for (int v = 0; v < topology.mesh.vertex_count(); ++v)
    if (topology.stars.triangle_count(v) > 0)
      put_star(topology, v, stress, body_loads, boundary, moments);
  return moments;
}

}  // namespace ffcontact
