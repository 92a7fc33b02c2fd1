// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/composite_stress.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <array>

namespace ffcontact {

namespace {

using StressMap = Eigen::Matrix<double, 27, 14>;  ///< corner stresses (column-major 3 x 9) from the 14 loads
using LoadsMatrix = Eigen::Matrix<double, 14, 14>;

/// Corner numbers of subtriangle k: two vertices of the triangle and 3 for the centroid.
std::array<int, 3> subtriangle(int k) { return {(k + 1) % 3, (k + 2) % 3, 3}; }

/// Adds factor * (sigma n) at one corner to two rows of the conditions.
void add_traction(Eigen::MatrixXd& conditions, int row, int k, int corner, const Eigen::Vector2d& n, double factor) {
  const int first = 9 * k + 3 * corner;
  conditions(row, first) += factor * n.x();
  conditions(row, first + 2) += factor * n.y();
  conditions(row + 1, first + 1) += factor * n.y();
  conditions(row + 1, first + 2) += factor * n.x();
}

Eigen::Vector2d turned_right(const Eigen::Vector2d& v) { return {v.y(), -v.x()}; }

/// The conditions of the header on the reference triangle (0,0), (1,0), (0,1), solved for every unit load.
StressMap solve_reference() {
  Eigen::Matrix<double, 2, 4> x;
  x << 0, 1, 0, 1.0 / 3, 0, 0, 1, 1.0 / 3;
  Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(30, 27), right = Eigen::MatrixXd::Zero(30, 14);
  int row = 0;
  for (int k = 0; k < 3; ++k) {  // div sigma = sum of sigma grad(phi) = -f = -2 (f |E|), |E| = 1/2
    const std::array<int, 3> s = subtriangle(k);
    constexpr double twice_area = 1.0 / 3;
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector2d opposite = x.col(s[(c + 2) % 3]) - x.col(s[(c + 1) % 3]);
      add_traction(conditions, row, k, c, -turned_right(opposite) / twice_area, 1);
    }
    right(row, 12) = right(row + 1, 13) = -2;
    row += 2;
  }
  for (int vertex = 0; vertex < 3; ++vertex) {  // continuity on the edge from a vertex to the centroid, at both ends
    const Eigen::Vector2d n = turned_right(x.col(3) - x.col(vertex));
    const int before = (vertex + 2) % 3, after = (vertex + 1) % 3;  // the two subtriangles that have this vertex
    for (int end = 0; end < 2; ++end, row += 2)
      for (int k : {before, after}) {
        const std::array<int, 3> s = subtriangle(k);
        const int corner = end == 1 ? 2 : (s[0] == vertex ? 0 : 1);
        add_traction(conditions, row, k, corner, n, k == before ? 1 : -1);
      }
  }
  for (int k = 0; k < 3; ++k) {  // moments b_i = l (2 F_i + F_j) / 6 on the outer edge k
    const Eigen::Vector2d n_times_length = turned_right(x.col((k + 2) % 3) - x.col((k + 1) % 3));
    for (int end = 0; end < 2; ++end, row += 2) {
      add_traction(conditions, row, k, end, n_times_length, 2.0 / 6);
      add_traction(conditions, row, k, 1 - end, n_times_length, 1.0 / 6);
      right(row, 4 * k + 2 * end) = right(row + 1, 4 * k + 2 * end + 1) = 1;
    }
  }
  return conditions.completeOrthogonalDecomposition().solve(right);
}

const StressMap& reference_map() {
  static const StressMap map = solve_reference();
  return map;
}

/// Integrals of products of corner values over a subtriangle of area A: A/12 (1 + delta).
double mass(double area, int a, int b) { return area / (a == b ? 6 : 12); }

/// R_pq with loads' R_pq loads = int s_p s_q over the reference triangle, for Voigt components p <= q (the products p q and
/// q p are added up).
std::array<LoadsMatrix, 6> solve_reference_products() {
  constexpr double area = 1.0 / 6;
  const StressMap& map = reference_map();
  std::array<LoadsMatrix, 6> products;
  int next = 0;
  for (int p = 0; p < 3; ++p)
    for (int q = p; q < 3; ++q) {
      LoadsMatrix R = LoadsMatrix::Zero();
      for (int k = 0; k < 3; ++k)
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            R += mass(area, a, b) * map.row(9 * k + 3 * a + p).transpose() * map.row(9 * k + 3 * b + q);
      products[next++] = p == q ? R : LoadsMatrix(R + R.transpose());
    }
  return products;
}

const std::array<LoadsMatrix, 6>& reference_products() {
  static const std::array<LoadsMatrix, 6> products = solve_reference_products();
  return products;
}

Eigen::Matrix2d piola_matrix(const TriangleCorners& corners) {
  Eigen::Matrix2d B;
  B << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  return B;
}

/// T with sigma = T s / det B in Voigt order, for sigma = B s B' / det B.
Eigen::Matrix3d piola_voigt(const Eigen::Matrix2d& B) {
  const double a = B(0, 0), b = B(0, 1), c = B(1, 0), d = B(1, 1);
  Eigen::Matrix3d T;
  T << a * a, b * b, 2 * a * b,  //
      c * c, d * d, 2 * c * d,   //
      a * c, b * d, a * d + b * c;
  return T;
}

}  // namespace

CompositeStress composite_stress(const TriangleCorners& corners, const TriangleLoads& loads) {
  const Eigen::Matrix2d B = piola_matrix(corners);
  TriangleLoads reference;
  Eigen::Map<Eigen::Matrix<double, 2, 7>>(reference.data()) =
      B.inverse() * Eigen::Map<const Eigen::Matrix<double, 2, 7>>(loads.data());
  const Eigen::Matrix<double, 27, 1> s = reference_map() * reference;
  return piola_voigt(B) / B.determinant() * Eigen::Map<const CompositeStress>(s.data());
}

Eigen::Matrix<double, 14, 14> composite_energy(const TriangleCorners& corners, const Eigen::Matrix3d& compliance) {
  const Eigen::Matrix2d B = piola_matrix(corners), inverse = B.inverse();
  const Eigen::Matrix3d T = piola_voigt(B);
  const Eigen::Matrix3d weight = T.transpose() * compliance * T / B.determinant();
  const std::array<LoadsMatrix, 6>& R = reference_products();
  const LoadsMatrix reference = weight(0, 0) * R[0] + weight(0, 1) * R[1] + weight(0, 2) * R[2] + weight(1, 1) * R[3] +
                                weight(1, 2) * R[4] + weight(2, 2) * R[5];
  LoadsMatrix result;
  for (int i = 0; i < 14; i += 2)
    for (int j = 0; j < 14; j += 2)
      result.block<2, 2>(i, j) = inverse.transpose() * reference.block<2, 2>(i, j) * inverse;
  return result;
}

double energy(const TriangleCorners& corners, const Eigen::Matrix3d& compliance, const CompositeStress& stress) {
  const double area = piola_matrix(corners).determinant() / 6;
  const CompositeStress strain = compliance * stress;
  double sum = 0;
  for (int k = 0; k < 9; k += 3)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) sum += mass(area, a, b) * stress.col(k + a).dot(strain.col(k + b));
  return sum;
}

Eigen::Vector4d density_of_moments(const Eigen::Vector4d& moments, double length) {
  Eigen::Vector4d density;
  density << 2 * moments.head<2>() - moments.tail<2>(), 2 * moments.tail<2>() - moments.head<2>();
  return 2 / length * density;
}

Eigen::Vector4d moments_of_density(const Eigen::Vector4d& density, double length) {
  Eigen::Vector4d moments;
  moments << 2 * density.head<2>() + density.tail<2>(), 2 * density.tail<2>() + density.head<2>();
  return length / 6 * moments;
}

}  // namespace ffcontact
