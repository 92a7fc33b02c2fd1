// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/refined_moments.hpp"

#include <map>

#include "ffcontact/base/least_squares.hpp"
#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

namespace {

/// The moments of the same traction seen along the edge the other way round, with the
/// normal turned too.
Vector4d reversed(const Vector4d& moments) {
  Vector4d result;
  result << -moments.tail<2>(), -moments.head<2>();
  return result;
}

/// Is the edge a part of its parent, which was cut?
bool is_cut(const Edges& old_edges, const CommonRefinement& refinement,
            int edge) {
  const int old = refinement.parent_edge[edge];
  for (int end = 0; end < 2; ++end) {
    const int vertex = refinement.edges.vertices(end, edge);
    if (vertex != old_edges.vertices(0, old) &&
        vertex != old_edges.vertices(1, old))
      return true;
  }
  return false;
}

/// Forces on the three vertices of a triangle from the moments of one of its edges: rows
/// (2 local + component) for (b_first, b_second).
Matrix<double, 6, 4> vertex_forces(const Edges& edges, int triangle, int side) {
  // from local vertex side + 1 to side + 2
  const bool forward = edges.eta(side, triangle) > 0;
  Matrix<double, 6, 4> forces = Matrix<double, 6, 4>::Zero();
  forces.block<2, 2>(2 * ((side + (forward ? 1 : 2)) % 3), 0) =
      edges.eta(side, triangle) * Matrix2d::Identity();
  forces.block<2, 2>(2 * ((side + (forward ? 2 : 1)) % 3), 2) =
      edges.eta(side, triangle) * Matrix2d::Identity();
  return forces;
}

/// Resultant and moment about the centroid, divided by the size, of forces on the
/// vertices [3 x 6].
Matrix<double, 3, 6> resultants(const Mesh& mesh, int triangle) {
  const Vector2d centre = (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) +
                           mesh.corner(triangle, 2)) /
                          3;
  double size = 0;
  for (int k = 0; k < 3; ++k)
    size = std::max(size, (mesh.corner(triangle, k) - centre).norm());
  Matrix<double, 3, 6> result;
  for (int k = 0; k < 3; ++k) {
    const Vector2d arm = (mesh.corner(triangle, k) - centre) / size;
    result.block<3, 2>(0, 2 * k) << 1, 0, 0, 1, -arm.y(), arm.x();
  }
  return result;
}

/// Balances the triangles of one fan by the moments of the edges between them.
void balance_fan(const CommonRefinement& refinement,
                 const std::vector<int>& triangles, const Vector3d& stress,
                 const BodyLoadsOfAll& body_loads, EdgeMoments& moments) {
  const Edges& edges = refinement.edges;
  std::map<int, int> column;  // of each inner edge
  for (int t : triangles)
    for (int edge : edges.of_cell.col(t))
      if (refinement.parent_edge[edge] < 0 &&
          column.emplace(edge, 4 * static_cast<int>(column.size())).second) {
        const Vector2d half =
            0.5 * edge_vector(refinement.mesh, edges, edge).norm() *
            traction(stress, edge_normal(refinement.mesh, edges, edge));
        moments.col(edge) << half, half;
      }
  const auto rows = static_cast<Index>(3 * triangles.size());
  MatrixXd conditions =
      MatrixXd::Zero(rows, static_cast<Index>(4 * column.size()));
  VectorXd left_over = VectorXd::Zero(rows);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const int t = triangles[k];
    const Matrix<double, 3, 6> R = resultants(refinement.mesh, t);
    left_over.segment<3>(3 * k) += R * body_loads.col(t);
    for (int side = 0; side < 3; ++side) {
      const int edge = edges.of_cell(side, t);
      const Matrix<double, 3, 4> effect = R * vertex_forces(edges, t, side);
      left_over.segment<3>(3 * k) += effect * moments.col(edge);
      if (const auto inner = column.find(edge); inner != column.end())
        conditions.block<3, 4>(3 * k, inner->second) = effect;
    }
  }
  const VectorXd change = -least_squares(conditions, left_over);
  for (const auto& [edge, first] : column)
    moments.col(edge) += change.segment<4>(first);
}

}  // namespace

BoundaryTractions tractions_of_parts(const Edges& old_edges,
                                     const CommonRefinement& refinement,
                                     const BoundaryTractions& cut,
                                     BoundaryTractions boundary) {
  std::map<int, Vector4d> sums;
  for (const FacingPiece& piece : refinement.line.pieces)
    for (const int edge :
         {refinement.line.edge[piece.contact_edge], piece.opposite_edge})
      sums.emplace(refinement.parent_edge[edge], Vector4d::Zero());
  for (int e = 0; e < refinement.line.edge_count();
       ++e)  // those on a rigid foundation
    sums.emplace(refinement.parent_edge[refinement.line.edge[e]],
                 Vector4d::Zero());
  for (int edge = 0; edge < refinement.edges.count(); ++edge) {
    const auto sum = sums.find(refinement.parent_edge[edge]);
    if (sum == sums.end()) continue;
    for (int end = 0; end < 2; ++end) {
      const double place = refinement.place(
          old_edges, refinement.edges.vertices(end, edge), sum->first);
      const Vector2d b = cut.moments.col(edge).segment<2>(2 * end);
      sum->second.head<2>() += (1 - place) * b;
      sum->second.tail<2>() += place * b;
    }
  }
  for (const auto& [old, sum] : sums) {
    boundary.known.col(old).setConstant(true);
    boundary.moments.col(old) = sum;
  }
  return boundary;
}

EdgeMoments refined_moments(const Edges& old_edges,
                            const CommonRefinement& refinement,
                            const EdgeMoments& old_moments,
                            const Ref<const Matrix3Xd>& old_stress,
                            const BodyLoadsOfAll& body_loads,
                            const BoundaryTractions& cut) {
  const Edges& edges = refinement.edges;
  EdgeMoments moments = EdgeMoments::Zero(4, edges.count());
  for (int edge = 0; edge < edges.count(); ++edge) {
    const int old = refinement.parent_edge[edge];
    if (old < 0) continue;
    if (is_cut(old_edges, refinement, edge))
      moments.col(edge) = cut.moments.col(edge);
    else
      moments.col(edge) = edges.vertices(0, edge) == old_edges.vertices(0, old)
                              ? Vector4d(old_moments.col(old))
                              : reversed(old_moments.col(old));
  }
  std::map<int, std::vector<int>> fans;
  for (int t = static_cast<int>(old_stress.cols());
       t < refinement.mesh.cell_count(); ++t) {
    std::vector<int>& fan = fans[refinement.parent[t]];
    if (fan.empty()) fan.push_back(refinement.parent[t]);
    fan.push_back(t);
  }
  for (const auto& [old, fan] : fans)
    balance_fan(refinement, fan, old_stress.col(old), body_loads, moments);
  return moments;
}

BodyLoadsOfAll refined_body_loads(const Mesh& old_mesh,
                                  const CommonRefinement& refinement,
                                  const BodyLoadsOfAll& old_loads) {
  const Mesh& mesh = refinement.mesh;
  BodyLoadsOfAll loads(6, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const int old = refinement.parent[t];
    const Map<const Matrix<double, 2, 3>> b(old_loads.col(old).data());
    // int f phi_i = |E| (F_i + sum F) / 12 for vertex values F of a linear f, so that F_i
    // = (12 b_i - 3 sum b) / |E|
    const Matrix<double, 2, 3> F =
        (12 * b - 3 * b.rowwise().sum().replicate<1, 3>()) /
        signed_area(old_mesh, old);
    Matrix<double, 2, 3> at_corners;
    for (int k = 0; k < 3; ++k) {
      at_corners.col(k).setZero();
      for (int i = 0; i < 3; ++i)
        at_corners.col(k) += refinement.vertex_weights.coeff(
                                 mesh.cells(k, t), old_mesh.cells(i, old)) *
                             F.col(i);
    }
    Map<Matrix<double, 2, 3>> part(loads.col(t).data());
    part = signed_area(mesh, t) / 12 *
           (at_corners + at_corners.rowwise().sum().replicate<1, 3>());
  }
  return loads;
}

Matrix4Xd refined_boundary_moments(const Mesh& old_mesh,
                                   const CommonRefinement& refinement,
                                   const Ref<const Matrix4Xd>& old_moments) {
  const Mesh& mesh = refinement.mesh;
  const auto length = [](const Mesh& of, Index b) {
    return (of.vertices.col(of.boundary(1, b)) -
            of.vertices.col(of.boundary(0, b)))
        .norm();
  };
  Matrix4Xd moments(4, mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    const int old = refinement.parent_boundary[b];
    const Vector4d ends =
        density_of_moments(old_moments.col(old), length(old_mesh, old));
    Vector4d density = Vector4d::Zero();
    for (int end = 0; end < 2; ++end)
      for (int i = 0; i < 2; ++i)
        density.segment<2>(2 * end) +=
            refinement.vertex_weights.coeff(mesh.boundary(end, b),
                                            old_mesh.boundary(i, old)) *
            ends.segment<2>(2 * i);
    moments.col(b) = moments_of_density(density, length(mesh, b));
  }
  return moments;
}

}  // namespace ffcontact
