// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/edge_moments.hpp"

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/nodal_residual.hpp"

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
Matrix2Xd sums_before(const Matrix2Xd& loads, Index spokes) {
  Matrix2Xd sums = Matrix2Xd::Zero(2, spokes);
  for (Index k = 0; k + 1 < spokes; ++k)
    sums.col(k + 1) = sums.col(k) + loads.col(k);
  return sums;
}

/// Component c of the moments at a vertex, seen along vertex -> neighbour with the normal
/// to the right: moment(0) - sum(k) on spoke k.
struct Chain {
  const Topology& topology;
  const BoundaryTractions& boundary;
  int vertex, c;
  const Matrix2Xd& sum;

  /// moment(0): from a known one, or nearest to the mean stresses.
  double start(const Matrix2Xd& mean) const {
    const auto [first, last] = end_spokes(topology.stars, vertex);
    if (boundary.known(c, first)) return given(first);
    if (boundary.known(c, last)) return given(last) + sum(c, sum.cols() - 1);
    return (mean.row(c) + sum.row(c)).mean();
  }

  double given(int spoke) const {
    return moment_at(topology.edges, boundary.moments, spoke, vertex)[c];
  }

  /// @param moment  on spoke k
  void put(int k, double moment, EdgeMoments& moments) const {
    const Stars& stars = topology.stars;
    const int spoke = stars.spoke[stars.spoke_start[vertex] + k];
    if (boundary.known(c, spoke)) return;
    const double sign = direction(topology.edges, spoke, vertex);
    moments((sign > 0 ? 0 : 2) + c, spoke) = sign * moment;
  }
};

/// The moments of the spokes of one star.
void put_star(const Topology& topology, int vertex,
              const Ref<const Matrix3Xd>& stress,
              const BodyLoadsOfAll& body_loads,
              const BoundaryTractions& boundary, EdgeMoments& moments) {
  const Matrix2Xd mean = mean_moments(topology, vertex, stress);
  const Matrix2Xd sum = sums_before(
      star_loads(topology, vertex, stress, body_loads), mean.cols());
  for (int c = 0; c < 2; ++c) {
    const Chain chain{topology, boundary, vertex, c, sum};
    const double start = chain.start(mean);
    for (int k = 0; k < sum.cols(); ++k)
      chain.put(k, start - sum(c, k), moments);
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
