// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/refined_moments.hpp"

#include <map>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"

namespace ffcontact {

namespace {

bool ends_at(const Edges& edges, int edge, int vertex) {
  return (edges.vertices.col(edge).array() == vertex).any();
}

/// Is the edge a part of its parent, which was cut?
bool is_cut(const Edges& old_edges, const CommonRefinement& refinement,
            int edge) {
  const int old = refinement.parent_edge[edge];
  const Vector2i ends = refinement.edges.vertices.col(edge);
  return !ends_at(old_edges, old, ends[0]) || !ends_at(old_edges, old, ends[1]);
}

/// Resultant and moment about the centroid, divided by the size, of forces on the
/// vertices [3 x 6].
Matrix<double, 3, 6> resultants(const Mesh& mesh, int triangle) {
  const CellCorners<2> arms =
      corners_of(mesh, triangle).colwise() - centroid_of(mesh, triangle);
  const double size = arms.colwise().norm().maxCoeff();
  Matrix<double, 3, 6> result;
  for (int k = 0; k < 3; ++k) {
    const Vector2d arm = arms.col(k) / size;
    result.block<3, 2>(0, 2 * k) << 1, 0, 0, 1, -arm.y(), arm.x();
  }
  return result;
}

/// Resultants of a triangle from the moments of one of its edges: these are forces on the
/// ends of the edge.
/// @param R  resultants
Matrix<double, 3, 4> resultants_of_edge(const Matrix<double, 3, 6>& R,
                                        const Edges& edges, int triangle,
                                        int side) {
  const double eta = edges.eta(side, triangle);
  // from local vertex side + 1 to side + 2, or back
  const int first = (side + (eta > 0 ? 1 : 2)) % 3,
            second = (side + (eta > 0 ? 2 : 1)) % 3;
  Matrix<double, 3, 4> effect;
  for (int c = 0; c < 2; ++c) {
    effect.col(c) = eta * R.col(2 * first + c);
    effect.col(2 + c) = eta * R.col(2 * second + c);
  }
  return effect;
}

/// The edges between the triangles of a fan, each with its column among their moments.
std::map<int, int> inner_edges(const CommonRefinement& refinement,
                               const std::vector<int>& triangles) {
  std::map<int, int> column;
  for (int t : triangles)
    for (int edge : refinement.edges.of_cell.col(t))
      if (refinement.parent_edge[edge] < 0)
        column.emplace(edge, 4 * static_cast<int>(column.size()));
  return column;
}

/// The moments of a constant stress.
Vector4d moments_of_stress(const Mesh& mesh, const Edges& edges, int edge,
                           const Vector3d& stress) {
  const Vector2d half = 0.5 * edge_vector(mesh, edges, edge).norm() *
                        traction(stress, edge_normal(mesh, edges, edge));
  return half.replicate<2, 1>();
}

/// conditions * (moments of the inner edges) + left_over = 0: resultants of each triangle
/// of a fan.
struct FanBalance {
  const Edges& edges;
  const std::map<int, int>& column;
  MatrixXd conditions;
  VectorXd left_over;

  FanBalance(const Edges& all, const std::map<int, int>& inner,
             std::size_t triangles)
      : edges(all),
        column(inner),
        conditions(MatrixXd::Zero(3 * triangles, 4 * inner.size())),
        left_over(VectorXd::Zero(3 * triangles)) {}

  /// @param R  resultants of triangle t, the k-th of the fan
  void add(std::size_t k, int t, const Matrix<double, 3, 6>& R,
           const EdgeMoments& moments) {
    for (int side = 0; side < 3; ++side) {
      const int edge = edges.of_cell(side, t);
      const Matrix<double, 3, 4> effect = resultants_of_edge(R, edges, t, side);
      left_over.segment<3>(3 * k) += effect * moments.col(edge);
      if (const auto inner = column.find(edge); inner != column.end())
        conditions.block<3, 4>(3 * k, inner->second) = effect;
    }
  }
};

/// Balances the triangles of one fan by the moments of the edges between them.
void balance_fan(const CommonRefinement& refinement,
                 const std::vector<int>& triangles, const Vector3d& stress,
                 const BodyLoadsOfCells<2>& body_loads, EdgeMoments& moments) {
  const Mesh& mesh = refinement.mesh;
  const Edges& edges = refinement.edges;
  const std::map<int, int> inner = inner_edges(refinement, triangles);
  for (const auto& [edge, first] : inner)
    moments.col(edge) = moments_of_stress(mesh, edges, edge, stress);
  FanBalance balance(edges, inner, triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const int t = triangles[k];
    const Matrix<double, 3, 6> R = resultants(mesh, t);
    balance.left_over.segment<3>(3 * k) += R * body_loads.col(t);
    balance.add(k, t, R, moments);
  }
  const VectorXd change = -least_squares(balance.conditions, balance.left_over);
  for (const auto& [edge, first] : inner)
    moments.col(edge) += change.segment<4>(first);
}

/// By old edge: moments with the hat functions of its ends.
using OldEdgeMoments = std::map<int, Vector4d>;

/// Zeros for the old edges that the contact line or an edge that it faces is a part of.
OldEdgeMoments zeros_along(const CommonRefinement& refinement) {
  const ContactLine& line = refinement.line;
  OldEdgeMoments zeros;
  const auto add = [&](int edge) {
    zeros.emplace(refinement.parent_edge[edge], Vector4d::Zero());
  };
  for (const FacingPiece& piece : line.pieces) add(piece.opposite_edge);
  for (const int edge : line.edge) add(edge);
  return zeros;
}

/// Adds a moment b at a place of the old edge.
void add_moment(const Vector2d& b, double place, Vector4d& sum) {
  sum.head<2>() += (1 - place) * b;
  sum.tail<2>() += place * b;
}

/// The moments of an old edge that was not cut, in the direction of the new one.
Vector4d moments_of_whole(const Edges& old_edges, const Edges& edges,
                          const EdgeMoments& old_moments, int edge, int old) {
  return edges.vertices(0, edge) == old_edges.vertices(0, old)
             ? Vector4d(old_moments.col(old))
             : reversed(old_moments.col(old));
}

using VertexVectors = Matrix<double, 2, 3>;

/// Vertex values F of the linear f with the moments b = int f phi_i = |E| (F_i + sum F) /
/// 12: F_i = (12 b_i - 3 sum b) / |E|.
VertexVectors vertex_values(const VertexVectors& b, double area) {
  return (12 * b - 3 * b.rowwise().sum().replicate<1, 3>()) / area;
}

/// The moments of the linear f with vertex values F.
VertexVectors moments_of_values(const VertexVectors& F, double area) {
  return area / 12 * (F + F.rowwise().sum().replicate<1, 3>());
}

/// Values at the vertices of the refinement of a function that is linear between some old
/// vertices.
/// @param values  at the old vertices, one column each
template <class OldVertices, class Vertices, class Values>
Values interpolated(const CommonRefinement& refinement, const OldVertices& old,
                    const Vertices& vertices, const Values& values) {
  Values result = Values::Zero();
  for (Index k = 0; k < vertices.size(); ++k)
    for (Index i = 0; i < old.size(); ++i)
      result.col(k) +=
          refinement.vertex_weights.coeff(vertices[k], old[i]) * values.col(i);
  return result;
}

}  // namespace

BoundaryTractions tractions_of_parts(const Edges& old_edges,
                                     const CommonRefinement& refinement,
                                     const BoundaryTractions& cut,
                                     BoundaryTractions boundary) {
  OldEdgeMoments sums = zeros_along(refinement);
  for (int edge = 0; edge < refinement.edges.count(); ++edge) {
    const auto sum = sums.find(refinement.parent_edge[edge]);
    if (sum == sums.end()) continue;
    for (int end = 0; end < 2; ++end) {
      const int vertex = refinement.edges.vertices(end, edge);
      add_moment(cut.moments.col(edge).segment<2>(2 * end),
                 refinement.place(old_edges, vertex, sum->first), sum->second);
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
                            const BodyLoadsOfCells<2>& body_loads,
                            const BoundaryTractions& cut) {
  const Edges& edges = refinement.edges;
  EdgeMoments moments = EdgeMoments::Zero(4, edges.count());
  for (int edge = 0; edge < edges.count(); ++edge) {
    const int old = refinement.parent_edge[edge];
    if (old < 0) continue;
    moments.col(edge) =
        is_cut(old_edges, refinement, edge)
            ? Vector4d(cut.moments.col(edge))
            : moments_of_whole(old_edges, edges, old_moments, edge, old);
  }
  const auto old_triangles = static_cast<int>(old_stress.cols());
  for (const auto& [old, fan] : fans_of(refinement, old_triangles))
    balance_fan(refinement, fan, old_stress.col(old), body_loads, moments);
  return moments;
}

std::map<int, std::vector<int>> fans_of(const CommonRefinement& refinement,
                                        int old_triangles) {
  std::map<int, std::vector<int>> fans;
  for (int t = old_triangles; t < refinement.mesh.cell_count(); ++t) {
    const int parent = refinement.parent[t];
    std::vector<int>& fan = fans[parent];
    if (fan.empty()) fan.push_back(parent);
    fan.push_back(t);
  }
  return fans;
}

BodyLoadsOfCells<2> refined_body_loads(const Mesh& old_mesh,
                                       const CommonRefinement& refinement,
                                       const BodyLoadsOfCells<2>& old_loads) {
  const Mesh& mesh = refinement.mesh;
  BodyLoadsOfCells<2> loads(6, mesh.cells.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const int old = refinement.parent[t];
    const VertexVectors F = vertex_values(old_loads.col(old).reshaped(2, 3),
                                          signed_area(old_mesh, old));
    const VertexVectors at_corners =
        interpolated(refinement, old_mesh.cells.col(old), mesh.cells.col(t), F);
    loads.col(t) =
        moments_of_values(at_corners, signed_area(mesh, t)).reshaped();
  }
  return loads;
}

Matrix4Xd refined_boundary_moments(const Mesh& old_mesh,
                                   const CommonRefinement& refinement,
                                   const Ref<const Matrix4Xd>& old_moments) {
  const Mesh& mesh = refinement.mesh;
  Matrix4Xd moments(4, mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    const int old = refinement.parent_boundary[b];
    const Matrix2d ends = facet_density<2>(old_moments.col(old).reshaped(2, 2),
                                           boundary_measure(old_mesh, old));
    const Matrix2d density = interpolated(
        refinement, old_mesh.boundary.col(old), mesh.boundary.col(b), ends);
    moments.col(b) =
        facet_moments_of<2>(density, boundary_measure(mesh, b)).reshaped();
  }
  return moments;
}

}  // namespace ffcontact
