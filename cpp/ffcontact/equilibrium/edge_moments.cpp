// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/edge_moments.hpp"

#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

namespace {

/// Loads and stresses that differ by more than this part of the largest moment were not
/// computed from each other.
constexpr double unbalanced = 1e-6;

/// The moments of the spokes of one star, seen along vertex -> neighbour with the normal
/// to the right, so that triangle k has moment(k) on its right side and moment(k + 1) on
/// its left: moment(k) - moment(k+1) = load(k).
struct StarChain {
  Matrix2Xd load;    ///< per triangle
  Matrix2Xd target;  ///< per spoke: from the mean stress
  /// per spoke: loads before it, so that moment(k) = moment(0) - sum(k)
  Matrix2Xd sum;
};

/// +1 when the spoke starts at the vertex.
double direction(const Edges& edges, int spoke, int vertex) {
  return edges.vertices(0, spoke) == vertex ? 1 : -1;
}

/// Rows of a moments column that belong to the vertex.
int rows_of(const Edges& edges, int spoke, int vertex) {
  return edges.vertices(0, spoke) == vertex ? 0 : 2;
}

StarChain star_chain(const Mesh& mesh, const Edges& edges, const Stars& stars, int vertex,
                     const Ref<const Matrix3Xd>& stress,
                     const BodyLoadsOfAll& body_loads) {
  const int triangles = stars.triangle_count(vertex), spokes = stars.spoke_count(vertex);
  StarChain chain;
  chain.load.resize(2, triangles);
  chain.target.resize(2, spokes);
  chain.sum = Matrix2Xd::Zero(2, spokes);
  for (int k = 0; k < triangles; ++k) {
    const int t = stars.triangle[stars.triangle_start[vertex] + k],
              local = stars.local[stars.triangle_start[vertex] + k];
    chain.load.col(k) = signed_area(mesh, t) *
                            traction(stress.col(t), hat_gradients(mesh, t).col(local)) -
                        body_loads.block<2, 1>(2 * local, t);
    if (k + 1 < spokes) chain.sum.col(k + 1) = chain.sum.col(k) + chain.load.col(k);
  }
  for (int k = 0; k < spokes; ++k) {
    const int spoke = stars.spoke[stars.spoke_start[vertex] + k];
    const int left = edges.cells(0, spoke), right = edges.cells(1, spoke);
    const Vector3d mean = right < 0
                              ? Vector3d(stress.col(left))
                              : Vector3d(0.5 * (stress.col(left) + stress.col(right)));
    const double half_length = 0.5 * edge_vector(mesh, edges, spoke).norm();
    chain.target.col(k) = direction(edges, spoke, vertex) * half_length *
                          traction(mean, edge_normal(mesh, edges, spoke));
  }
  return chain;
}

}  // namespace

NodalEquilibrium nodal_equilibrium(const Mesh& mesh, const Edges& edges,
                                   const Stars& stars, const Ref<const Matrix3Xd>& stress,
                                   const BodyLoadsOfAll& body_loads,
                                   const BoundaryTractions& boundary) {
  EdgeMoments moments = boundary.moments;
  double scale = moments.cwiseAbs().maxCoeff();
  Matrix2Xd missing = Matrix2Xd::Zero(2, mesh.vertex_count());
#pragma omp parallel for reduction(max : scale)
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (stars.triangle_count(v) == 0) continue;
    const StarChain chain = star_chain(mesh, edges, stars, v, stress, body_loads);
    const int* spokes = stars.spoke.data() + stars.spoke_start[v];
    const int last = stars.spoke_count(v) - 1;
    scale = std::max(scale, chain.load.cwiseAbs().maxCoeff());

    for (int c = 0; c < 2; ++c) {
      const auto given = [&](int k) {
        return direction(edges, spokes[k], v) *
               boundary.moments(rows_of(edges, spokes[k], v) + c, spokes[k]);
      };
      const bool at_first = boundary.known(c, spokes[0]),
                 at_last = boundary.known(c, spokes[last]);
      const double start = at_first  ? given(0)
                           : at_last ? given(last) + chain.sum(c, last)
                                     : (chain.target.row(c) + chain.sum.row(c)).mean();
      if (!stars.on_boundary(v))
        missing(c, v) = -chain.load.row(c).sum();
      else if (at_first && at_last)
        missing(c, v) = start - chain.sum(c, last) - given(last);
      for (int k = 0; k <= last; ++k)
        if (!boundary.known(c, spokes[k]))
          moments(rows_of(edges, spokes[k], v) + c, spokes[k]) =
              direction(edges, spokes[k], v) * (start - chain.sum(c, k));
    }
  }
  return {std::move(moments), std::move(missing), scale};
}

void require_balanced(const Mesh& mesh, const NodalEquilibrium& equilibrium,
                      double least_scale) {
  Index component, vertex;
  const double worst = equilibrium.missing.cwiseAbs().maxCoeff(&component, &vertex);
  if (worst <= unbalanced * std::max(least_scale, equilibrium.scale)) return;
  const Vector2d x = mesh.origin + mesh.vertices.col(vertex);
  std::ostringstream sentence;
  sentence.precision(10);
  sentence << "the loads do not balance the stresses at vertex " << vertex << " ("
           << x.x() << ", " << x.y() << "): " << worst << " N/mm are left over";
  throw Imbalance(sentence.str(), static_cast<int>(vertex), static_cast<int>(component));
}

EdgeMoments equilibrated_moments(const Mesh& mesh, const Edges& edges, const Stars& stars,
                                 const Ref<const Matrix3Xd>& stress,
                                 const BodyLoadsOfAll& body_loads,
                                 const BoundaryTractions& boundary) {
  NodalEquilibrium equilibrium =
      nodal_equilibrium(mesh, edges, stars, stress, body_loads, boundary);
  require_balanced(mesh, equilibrium);
  return std::move(equilibrium.moments);
}

}  // namespace ffcontact
