// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/boundary_tractions.hpp"
#include "ffcontact/equilibrium/difference_loads.hpp"

namespace ffcontact {

/// Changes of the edge tractions that keep every triangle in equilibrium: stresses of an
/// Airy function A in the Hsieh-Clough-Tocher space, C1 and cubic on the three
/// subtriangles of each triangle.
///
/// Unknowns: (A / l0, A_x, A_y) at every vertex, l0 the mean length of its edges, then
/// dA/dn in the middle of every edge, along the edge's normal. All are forces per unit
/// thickness [N/mm]. With psi = (A_y, -A_x) the traction along an edge i -> j is d
/// psi/ds, linear in s, with the moments
///     b_i = (-5 psi_i + 4 psi_m + psi_j) / 6,   b_j = (-psi_i - 4 psi_m + 5 psi_j) / 6
/// on the normal to the right, where in the middle dA/ds = 3/2 (A_j - A_i) / l - 1/4
/// ((dA/ds)_i + (dA/ds)_j).
struct AirySpace {
  AirySpace(const Mesh& mesh, const Edges& edges);

  Index unknowns() const { return 3 * mesh.vertices.cols() + edges.count(); }
  Index of_vertex(int vertex) const {
    return 3 * static_cast<Index>(vertex);
  }  ///< the first of its three
  Index of_edge(int edge) const { return 3 * mesh.vertices.cols() + edge; }

  const Mesh& mesh;
  const Edges& edges;
  VectorXd length;  ///< l0 per vertex [mm]
};

/// The unknowns that take part in a triangle: column r for the r-th vertex, and those of
/// the edges opposite to them.
struct LocalAiry {
  Matrix3d at_vertices;
  Vector3d on_edges;
};

/// @param first  the local vertex to count from
inline LocalAiry local_airy(const AirySpace& space, const VectorXd& airy,
                            int triangle, int first = 0) {
  LocalAiry local;
  for (int r = 0; r < 3; ++r) {
    const int k = (first + r) % 3;
    const double* at_vertex =
        airy.data() + space.of_vertex(space.mesh.cells(k, triangle));
    for (int c = 0; c < 3; ++c) local.at_vertices(c, r) = at_vertex[c];
    local.on_edges[r] = airy[space.of_edge(space.edges.of_cell(k, triangle))];
  }
  return local;
}

/// (b_i, b_j) from the gradients of A at the ends and in the middle of an edge i -> j.
Vector4d moments_of_gradients(const Vector2d& at_i, const Vector2d& in_middle,
                              const Vector2d& at_j);

/// Moments (b_first, b_second) of the traction on an edge, for the edge's own normal
/// [N/mm].
Vector4d airy_moments(const AirySpace& space, const VectorXd& airy, int edge);

/// Adds the edge loads of an Airy function; the two sides of an edge get the same digits
/// with opposite signs.
void add_airy_loads(const AirySpace& space, const VectorXd& airy,
                    EdgeLoadsOfAll& loads);

}  // namespace ffcontact
