// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"

#include <array>
#include <cmath>

#include "ffcontact/base/over.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/difference_loads.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

TriangleCorners subtriangle_corners(const Mesh& mesh, int t, int k) {
  TriangleCorners x;
  x << mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3),
      centroid_of(mesh, t);
  return x;
}

Vector2d divergence(const TriangleCorners& x, const Matrix3d& corner_stress) {
  const Vector2d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0);
  const double twice_area = a.x() * b.y() - a.y() * b.x();
  Vector2d sum = Vector2d::Zero();
  for (int c = 0; c < 3; ++c)
    sum += traction(corner_stress.col(c),
                    -turned_right(side_of(x, c)) / twice_area);
  return sum;
}

double longest_side(const TriangleCorners& corners) {
  return largest_over(3, [&](int k) { return side_of(corners, k).norm(); });
}

/// Largest divergence times size over the subtriangles of one triangle.
double divergence_of_triangle(const Mesh& mesh, int t,
                              const CompositeStress& stress,
                              const BodyLoads& body_loads) {
  const double area = signed_area(mesh, t);
  const Matrix<double, 2, 3> f = body_force_of(body_loads, area);
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector2d div_sigma = divergence(subtriangle_corners(mesh, t, k),
                                          stress.middleCols<3>(3 * k));
    worst = std::max(worst, (div_sigma + f.col(k)).norm());
  }
  return worst * area / longest_side(corners_of(mesh, t));
}

/// Largest jump across the edge from a vertex to the centroid.
double jump_inside(const Mesh& mesh, int t, int vertex,
                   const CompositeStress& stress) {
  const Vector2d along = centroid_of(mesh, t) - mesh.corner(t, vertex);
  const Vector2d n = turned_right(along.normalized());
  // The vertex is corner 1 of the subtriangle opposite to its predecessor, and corner 0
  // of the other one.
  const int before = (vertex + 2) % 3, after = (vertex + 1) % 3;
  const Vector3d at_vertex = stress.col(3 * after + 1) - stress.col(3 * before);
  const Vector3d at_centroid =
      stress.col(3 * before + 2) - stress.col(3 * after + 2);
  return std::max(traction(at_vertex, n).norm(),
                  traction(at_centroid, n).norm());
}

/// sigma n of the triangle beside an edge, at the edge's first and second vertex, for the
/// edge's own normal.
Vector4d traction_beside(const Mesh& mesh, const Edges& edges, int edge, int t,
                         const std::vector<CompositeStress>& stress) {
  const int k = edges.side_of_cell(edge, t);
  const Vector2d n = edge_normal(mesh, edges, edge);
  // then the triangle runs through the edge from its first vertex to its second
  const bool same = edges.eta(k, t) > 0;
  Vector4d ends;
  ends << traction(stress[t].col(3 * k + (same ? 0 : 1)), n),
      traction(stress[t].col(3 * k + (same ? 1 : 0)), n);
  return ends;
}

/// Largest |sigma n - F| of the known components at the ends of a boundary edge.
double boundary_defect(const Mesh& mesh, const Edges& edges, int e,
                       const BoundaryTractions& boundary,
                       const Vector4d& traction) {
  const Vector4d given = density_of_moments(boundary.moments.col(e),
                                            edge_vector(mesh, edges, e).norm());
  double largest = 0;
  for (int k = 0; k < 4; ++k)
    if (boundary.known(k % 2, e))
      largest = std::max(largest, std::abs(traction[k] - given[k]));
  return largest;
}

}  // namespace

EquilibriumDefect equilibrium_defect(const Mesh& mesh, const Edges& edges,
                                     const std::vector<CompositeStress>& stress,
                                     const BodyLoadsOfAll& body_loads,
                                     const BoundaryTractions& boundary,
                                     double least_scale) {
  require_size("stress", static_cast<Index>(stress.size()), mesh.cell_count());
  require_size("body loads", body_loads.cols(), mesh.cell_count());
  double divergence = 0, jump = 0, at_boundary = 0, largest_traction = 0;
#pragma omp parallel for reduction(max : divergence, jump)
  for (int t = 0; t < mesh.cell_count(); ++t) {
    divergence =
        std::max(divergence,
                 divergence_of_triangle(mesh, t, stress[t], body_loads.col(t)));
    for (int k = 0; k < 3; ++k)
      jump = std::max(jump, jump_inside(mesh, t, k, stress[t]));
  }
#pragma omp parallel for reduction(max : jump, at_boundary, largest_traction)
  for (int e = 0; e < edges.count(); ++e) {
    const Vector4d left =
        traction_beside(mesh, edges, e, edges.cells(0, e), stress);
    largest_traction = std::max(largest_traction, max_norm(left));
    if (edges.on_boundary(e)) {
      at_boundary = std::max(at_boundary,
                             boundary_defect(mesh, edges, e, boundary, left));
    } else {
      const Vector4d right =
          traction_beside(mesh, edges, e, edges.cells(1, e), stress);
      jump = std::max(jump, max_norm(left - right));
    }
  }
  const double largest = std::max(largest_traction, least_scale),
               scale = largest > 0 ? largest : 1;
  return {divergence / scale, jump / scale, at_boundary / scale};
}

}  // namespace ffcontact
