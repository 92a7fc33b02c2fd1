// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_energy.hpp"

#include <cmath>

#include "ffcontact/equilibrium/airy_reference.hpp"

namespace ffcontact {

namespace {

using EdgesByVertices = Matrix<double, 3, 9>;
using VertexEnergy = Matrix<double, 9, 9>;

/// The reference unknowns from those of a triangle: at the vertices (A, grad A) = (l0 x,
/// B' x), in the middle of edge k
///     q = normal[k] x + from_vertices.row(k) (A, grad A).
struct Pullback {
  Matrix2d B;
  double determinant;
  Vector3d length, normal;
  EdgesByVertices from_vertices = EdgesByVertices::Zero();

  Pullback(const AirySpace& space, int triangle, const TriangleCorners& corners)
      : B(piola_matrix(corners)) {
    determinant = B(0, 0) * B(1, 1) - B(0, 1) * B(1, 0);
    for (int k = 0; k < 3; ++k) {
      length[k] = space.length[space.mesh.cells(k, triangle)];
      put_edge(k, side_of(corners, k), space.edges.eta(k, triangle));
    }
  }

  /// q is the derivative across the reference edge: part of it runs along the edge e.
  void put_edge(int k, const Vector2d& e, double eta) {
    const Vector2d reference_e = side_of(reference_triangle(), k);
    const Vector2d across = B * turned_right(reference_e);
    const double square = e.squaredNorm(), along = across.dot(e) / square;
    normal[k] = eta * across.dot(turned_right(e)) / std::sqrt(square);
    const Vector2d by_gradients = -0.25 * along * reference_e;
    put_vertex(k, (k + 1) % 3, along * -1.5, by_gradients);
    put_vertex(k, (k + 2) % 3, along * 1.5, by_gradients);
  }

  void put_vertex(int k, int vertex, double by_value,
                  const Vector2d& by_gradient) {
    from_vertices.block<1, 3>(k, 3 * vertex) << by_value,
        by_gradient.transpose();
  }

  /// G_i' M G_j for G_k = diag(l0_k, B').
  Matrix3d block(const Matrix3d& M, int i, int j) const {
    Matrix3d result;
    result(0, 0) = length[i] * M(0, 0) * length[j];
    result.block<1, 2>(0, 1) =
        length[i] * M.block<1, 2>(0, 1).lazyProduct(B.transpose());
    result.block<2, 1>(1, 0) = length[j] * B.lazyProduct(M.block<2, 1>(1, 0));
    const Matrix2d half = B.lazyProduct(M.block<2, 2>(1, 1));
    result.block<2, 2>(1, 1) = half.lazyProduct(B.transpose());
    return result;
  }
  Vector3d dual(const Vector3d& m, int i) const {
    const Vector2d gradient = B.lazyProduct(m.tail<2>());
    return {length[i] * m[0], gradient.x(), gradient.y()};
  }
};

/// The energy by (A, grad A) at the vertices and by the part normal[k] x of q.
struct SplitEnergy {
  VertexEnergy of_vertices;
  EdgesByVertices mixed;
  Matrix3d of_edges;
};

/// @param P  Pullback::from_vertices
SplitEnergy split_energy(const Matrix3d& weights, const EdgesByVertices& P) {
  const ReferenceEnergy S = weighted_products(weights);
  const Matrix3d of_edges = S.bottomRightCorner<3, 3>();
  const EdgesByVertices mixed = S.bottomLeftCorner<3, 9>(),
                        middle = of_edges.lazyProduct(P),
                        half = mixed + 0.5 * middle;
  const VertexEnergy side = P.transpose().lazyProduct(half);
  return {S.topLeftCorner<9, 9>() + side + side.transpose(), mixed + middle,
          of_edges};
}

/// Vertex k with itself and the next one.
void put_vertex(const Pullback& pullback, const SplitEnergy& split, int k,
                AiryEnergy& energy) {
  const int l = (k + 1) % 3;
  const Matrix3d own = split.of_vertices.block<3, 3>(3 * k, 3 * k),
                 next = split.of_vertices.block<3, 3>(3 * k, 3 * l);
  energy.own[k] = pullback.block(own, k, k);
  energy.next[k] = pullback.block(next, k, l);
}

/// Edge k with the vertices, itself and the next one.
void put_edge(const Pullback& pullback, const SplitEnergy& split, int k,
              AiryEnergy& energy) {
  const Vector3d& normal = pullback.normal;
  for (int r = 0; r < 3; ++r) {
    const int vertex = (k + r) % 3;
    const Vector3d mixed = split.mixed.block<1, 3>(k, 3 * vertex).transpose();
    energy.edge[k].col(r) = normal[k] * pullback.dual(mixed, vertex);
  }
  const int l = (k + 1) % 3;
  energy.edge_own[k] = normal[k] * split.of_edges(k, k) * normal[k];
  energy.edge_next[k] = normal[k] * split.of_edges(k, l) * normal[l];
}

void put_quadratic(const Pullback& pullback, const Matrix3d& weights,
                   AiryEnergy& energy) {
  const SplitEnergy split = split_energy(weights, pullback.from_vertices);
  for (int k = 0; k < 3; ++k) {
    put_vertex(pullback, split, k, energy);
    put_edge(pullback, split, k, energy);
  }
}

/// @param slope  per reference unknown
void put_slope(const Pullback& pullback, const ReferenceUnknowns& slope,
               AiryEnergy& energy) {
  const Vector3d on_edges = slope.tail<3>();
  const Matrix<double, 9, 1> at_vertices =
      slope.head<9>() +
      pullback.from_vertices.transpose().lazyProduct(on_edges);
  for (int k = 0; k < 3; ++k)
    energy.slope.at_vertices.col(k) =
        pullback.dual(at_vertices.segment<3>(3 * k), k);
  energy.slope.on_edges = pullback.normal.cwiseProduct(on_edges);
}

/// Vertex k of K x.
Vector3d row_of_vertex(const AiryEnergy& K, const LocalAiry& x, int k) {
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  Vector3d row = K.own[k].lazyProduct(x.at_vertices.col(k));
  row += K.next[k].lazyProduct(x.at_vertices.col(l));
  row += K.next[m].transpose().lazyProduct(x.at_vertices.col(m));
  row += K.edge[k].col(0) * x.on_edges[k];
  row += K.edge[l].col(2) * x.on_edges[l];
  row += K.edge[m].col(1) * x.on_edges[m];
  return row;
}

/// Edge k of K x.
double row_of_edge(const AiryEnergy& K, const LocalAiry& x, int k) {
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  return K.edge[k].col(0).dot(x.at_vertices.col(k)) +
         K.edge[k].col(1).dot(x.at_vertices.col(l)) +
         K.edge[k].col(2).dot(x.at_vertices.col(m)) +
         K.edge_own[k] * x.on_edges[k] + K.edge_next[k] * x.on_edges[l] +
         K.edge_next[m] * x.on_edges[m];
}

}  // namespace

LocalAiry AiryEnergy::times(const LocalAiry& x) const {
  LocalAiry y;
  for (int k = 0; k < 3; ++k) {
    y.at_vertices.col(k) = row_of_vertex(*this, x, k);
    y.on_edges[k] = row_of_edge(*this, x, k);
  }
  return y;
}

AiryEnergy airy_energy(const AirySpace& space, int triangle,
                       const Matrix3d& compliance, const EdgeLoads& difference,
                       const BodyLoads& body_loads) {
  const TriangleCorners corners = corners_of(space.mesh, triangle);
  const Pullback pullback(space, triangle, corners);
  const double determinant = pullback.determinant;
  // Over the reference triangle A has the stress s(A) / det B, of which Piola's map makes
  // sigma = T s(A).
  const Matrix3d T = piola_voigt(pullback.B) / (determinant * determinant);
  const Matrix3d dual = T.transpose() * compliance;

  AiryEnergy energy;
  put_quadratic(pullback, determinant * dual * T, energy);
  const CompositeStress tau = composite_stress(corners, difference, body_loads);
  const CompositeStress weighted = massed(tau, 0.5 * determinant);
  const CompositeStress reference_strain = dual * weighted;
  energy.before = (compliance * weighted).cwiseProduct(tau).sum();
  put_slope(pullback,
            reference_stress().transpose() * reference_strain.reshaped(),
            energy);
  return energy;
}

}  // namespace ffcontact
