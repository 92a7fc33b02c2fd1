// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/equilibrium_defect.hpp"

#include <array>
#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

namespace {

using SubtriangleCorners = Matrix<double, 2, 3>;

SubtriangleCorners subtriangle_corners(const Mesh& mesh, int t, int k) {
  SubtriangleCorners x;
  x.col(0) = mesh.corner(t, (k + 1) % 3);
  x.col(1) = mesh.corner(t, (k + 2) % 3);
  x.col(2) = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
  return x;
}

Vector2d divergence(const SubtriangleCorners& x,
                    const Matrix3d& corner_stress) {
  const Vector2d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0);
  const double twice_area = a.x() * b.y() - a.y() * b.x();
  Vector2d sum = Vector2d::Zero();
  for (int c = 0; c < 3; ++c) {
    const Vector2d opposite = x.col((c + 2) % 3) - x.col((c + 1) % 3);
    sum += traction(corner_stress.col(c),
                    Vector2d(-opposite.y(), opposite.x()) / twice_area);
  }
  return sum;
}

/// Largest divergence times size over the subtriangles of one triangle.
double divergence_of_triangle(const Mesh& mesh, int t,
                              const CompositeStress& stress,
                              const BodyLoads& body_loads) {
  const Matrix<double, 2, 3> f =
      body_force_of(body_loads, signed_area(mesh, t));
  double worst = 0, longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector2d left_over = divergence(subtriangle_corners(mesh, t, k),
                                          stress.middleCols<3>(3 * k)) +
                               f.col(k);
    worst = std::max(worst, left_over.norm());
    longest = std::max(
        longest, (mesh.corner(t, k) - mesh.corner(t, (k + 1) % 3)).norm());
  }
  return worst * signed_area(mesh, t) / longest;
}

/// Largest jump across the edges from the vertices to the centroid.
double jump_inside(const Mesh& mesh, int t, const CompositeStress& stress) {
  double worst = 0;
  for (int vertex = 0; vertex < 3; ++vertex) {
    const int before = (vertex + 2) % 3, after = (vertex + 1) % 3;
    const Vector2d along =
        (subtriangle_corners(mesh, t, 0).col(2) - mesh.corner(t, vertex))
            .normalized();
    const Vector2d n(along.y(), -along.x());
    // The vertex is corner 1 of the subtriangle opposite to its predecessor, and corner 0
    // of the other one.
    const Vector3d at_vertex =
        stress.col(3 * after + 1) - stress.col(3 * before);
    const Vector3d at_centroid =
        stress.col(3 * before + 2) - stress.col(3 * after + 2);
    worst = std::max({worst, traction(at_vertex, n).norm(),
                      traction(at_centroid, n).norm()});
  }
  return worst;
}

/// sigma n of the triangle beside an edge, at the edge's first and second vertex, for the
/// edge's own normal.
Vector4d traction_beside(const Mesh& mesh, const Edges& edges, int edge, int t,
                         const std::vector<CompositeStress>& stress) {
  const Vector2d n = edge_normal(mesh, edges, edge);
  for (int k = 0; k < 3; ++k) {
    if (edges.of_cell(k, t) != edge) continue;
    const bool same =
        // then the triangle runs through the edge from its first vertex to its second
        edges.eta(k, t) > 0;
    Vector4d ends;
    ends << traction(stress[t].col(3 * k + (same ? 0 : 1)), n),
        traction(stress[t].col(3 * k + (same ? 1 : 0)), n);
    return ends;
  }
  return Vector4d::Constant(std::nan(""));
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
    jump = std::max(jump, jump_inside(mesh, t, stress[t]));
  }
#pragma omp parallel for reduction(max : jump, at_boundary, largest_traction)
  for (int e = 0; e < edges.count(); ++e) {
    const Vector4d left =
        traction_beside(mesh, edges, e, edges.cells(0, e), stress);
    largest_traction = std::max(largest_traction, left.cwiseAbs().maxCoeff());
    if (edges.on_boundary(e)) {
      const Vector4d given = density_of_moments(
          boundary.moments.col(e), edge_vector(mesh, edges, e).norm());
      for (int k = 0; k < 4; ++k)
        if (boundary.known(k % 2, e))
          at_boundary = std::max(at_boundary, std::abs(left[k] - given[k]));
    } else {
      const Vector4d right =
          traction_beside(mesh, edges, e, edges.cells(1, e), stress);
      jump = std::max(jump, (left - right).cwiseAbs().maxCoeff());
    }
  }
  const double scale = std::max(largest_traction, least_scale) > 0
                           ? std::max(largest_traction, least_scale)
                           : 1;
  return {divergence / scale, jump / scale, at_boundary / scale};
}

}  // namespace ffcontact
