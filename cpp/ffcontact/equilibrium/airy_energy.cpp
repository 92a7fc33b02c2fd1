// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/airy_energy.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace ffcontact {

namespace {

/// On the reference triangle (0,0), (1,0), (0,1) the unknowns are (A, A_xi, A_eta) at the
/// vertices and, in the middle of each edge e, the derivative along e turned to the
/// right, outwards and as long as e.
using ReferenceUnknowns = Matrix<double, 12, 1>;
using ReferenceStress =
    /// corner stresses (CompositeStress by columns) of each unknown
    Matrix<double, 27, 12>;

const TriangleCorners& reference_corners() {
  static const TriangleCorners corners =
      (TriangleCorners() << 0, 1, 0, 0, 0, 1).finished();
  return corners;
}

Vector2d side(const TriangleCorners& corners, int k) {
  return corners.col((k + 2) % 3) - corners.col((k + 1) % 3);
}

/// Edge loads of an Airy function on the reference triangle, as airy_moments.
EdgeLoads reference_loads(const ReferenceUnknowns& x) {
  EdgeLoads loads;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vector2d e = side(reference_corners(), k),
                   gradient_i = x.segment<2>(3 * i + 1),
                   gradient_j = x.segment<2>(3 * j + 1);
    const double along =
        1.5 * (x[3 * j] - x[3 * i]) - 0.25 * e.dot(gradient_i + gradient_j);
    const Vector2d gradient_m =
        (along * e + x[9 + k] * turned_right(e)) / e.squaredNorm();
    loads.segment<2>(4 * k) =
        turned_right(-5 * gradient_i + 4 * gradient_m + gradient_j) / 6;
    loads.segment<2>(4 * k + 2) =
        turned_right(-gradient_i - 4 * gradient_m + 5 * gradient_j) / 6;
  }
  return loads;
}

const ReferenceStress& reference_stress() {
  static const ReferenceStress stress = [] {
    ReferenceStress result;
    for (int c = 0; c < 12; ++c)
      result.col(c) =
          composite_stress(reference_corners(),
                           reference_loads(ReferenceUnknowns::Unit(c)),
                           BodyLoads::Zero())
              .reshaped();
    return result;
  }();
  return stress;
}

/// Corner values times the mass matrix of their subtriangle, A/12 (1 + delta), for a
/// triangle of area 3 A.
CompositeStress massed(const CompositeStress& values, double area) {
  CompositeStress result;
  for (int k = 0; k < 9; k += 3) {
    const Vector3d sum = values.col(k) + values.col(k + 1) + values.col(k + 2);
    for (int a = k; a < k + 3; ++a)
      result.col(a) = area / 36 * (sum + values.col(a));
  }
  return result;
}

using ReferenceEnergy = Matrix<double, 12, 12>;

/// S_pq with x' S_pq x = int s_p s_q over the reference triangle for Voigt components p
/// <= q, the products p q and q p added up.
const std::array<ReferenceEnergy, 6>& reference_products() {
  static const std::array<ReferenceEnergy, 6> products = [] {
    std::array<ReferenceEnergy, 6> result;
    int next = 0;
    for (int p = 0; p < 3; ++p)
      for (int q = p; q < 3; ++q, ++next)
        for (int c = 0; c < 12; ++c) {
          const Map<const CompositeStress> stress(
              reference_stress().col(c).data());
          CompositeStress dual = CompositeStress::Zero();
          dual.row(p) += stress.row(q);
          if (p != q) dual.row(q) += stress.row(p);
          result[next].col(c) =
              reference_stress().transpose() * massed(dual, 0.5).reshaped();
        }
    return result;
  }();
  return products;
}

/// The reference unknowns from those of a triangle: at the vertices (A, grad A) = (l0 x,
/// B' x), in the middle of edge k
///     q = normal[k] x + from_vertices.row(k) (A, grad A).
struct Pullback {
  Matrix2d B;
  double determinant;
  Vector3d length, normal;
  Matrix<double, 3, 9> from_vertices = Matrix<double, 3, 9>::Zero();

  Pullback(const AirySpace& space, int triangle,
           const TriangleCorners& corners) {
    B << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
    determinant = B(0, 0) * B(1, 1) - B(0, 1) * B(1, 0);
    for (int k = 0; k < 3; ++k) {
      length[k] = space.length[space.mesh.cells(k, triangle)];
      const Vector2d e = side(corners, k),
                     reference_e = side(reference_corners(), k);
      const Vector2d across = B * turned_right(reference_e);
      const double square = e.squaredNorm(), along = across.dot(e) / square;
      normal[k] = space.edges.eta(k, triangle) * across.dot(turned_right(e)) /
                  std::sqrt(square);
      for (const auto& [vertex, sign] : {std::make_pair((k + 1) % 3, -1.5),
                                         std::make_pair((k + 2) % 3, 1.5)})
        from_vertices.block<1, 3>(k, 3 * vertex) << along * sign,
            -0.25 * along * reference_e.transpose();
    }
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
    return {length[i] * m[0], B(0, 0) * m[1] + B(0, 1) * m[2],
            B(1, 0) * m[1] + B(1, 1) * m[2]};
  }
};

void put_quadratic(const Pullback& pullback, const Matrix3d& weights,
                   AiryEnergy& energy) {
  const std::array<ReferenceEnergy, 6>& S = reference_products();
  const ReferenceEnergy reference =
      weights(0, 0) * S[0] + weights(0, 1) * S[1] + weights(0, 2) * S[2] +
      weights(1, 1) * S[3] + weights(1, 2) * S[4] + weights(2, 2) * S[5];
  const Matrix<double, 3, 9>& P = pullback.from_vertices;
  const Matrix3d of_edges = reference.bottomRightCorner<3, 3>();
  const Matrix<double, 3, 9> middle = of_edges.lazyProduct(P),
                             mixed = reference.bottomLeftCorner<3, 9>();
  const Matrix<double, 3, 9> half = mixed + 0.5 * middle,
                             whole = mixed + middle;
  const Matrix<double, 9, 9> side = P.transpose().lazyProduct(half);
  const Matrix<double, 9, 9> of_vertices =
      reference.topLeftCorner<9, 9>() + side + side.transpose();
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    energy.own[k] = pullback.block(of_vertices.block<3, 3>(3 * k, 3 * k), k, k);
    energy.next[k] =
        pullback.block(of_vertices.block<3, 3>(3 * k, 3 * l), k, l);
    for (int r = 0; r < 3; ++r)
      energy.edge[k].col(r) =
          pullback.normal[k] *
          pullback.dual(whole.block<1, 3>(k, 3 * ((k + r) % 3)).transpose(),
                        (k + r) % 3);
    energy.edge_own[k] =
        pullback.normal[k] * of_edges(k, k) * pullback.normal[k];
    energy.edge_next[k] =
        pullback.normal[k] * of_edges(k, l) * pullback.normal[l];
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

}  // namespace

LocalAiry AiryEnergy::times(const LocalAiry& x) const {
  LocalAiry y;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    y.at_vertices.col(k) =
        own[k].lazyProduct(x.at_vertices.col(k)) +
        next[k].lazyProduct(x.at_vertices.col(l)) +
        next[m].transpose().lazyProduct(x.at_vertices.col(m)) +
        edge[k].col(0) * x.on_edges[k] + edge[l].col(2) * x.on_edges[l] +
        edge[m].col(1) * x.on_edges[m];
    y.on_edges[k] = edge[k].col(0).dot(x.at_vertices.col(k)) +
                    edge[k].col(1).dot(x.at_vertices.col(l)) +
                    edge[k].col(2).dot(x.at_vertices.col(m)) +
                    edge_own[k] * x.on_edges[k] + edge_next[k] * x.on_edges[l] +
                    edge_next[m] * x.on_edges[m];
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
