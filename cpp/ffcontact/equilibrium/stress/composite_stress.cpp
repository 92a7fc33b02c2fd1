// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/composite_stress.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "ffcontact/base/over.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

namespace {

constexpr int loads_on_edges = 12, all_loads = 18;
using StressMap =
    /// corner stresses (column-major 3 x 9) from edge and body loads
    Matrix<double, 27, all_loads>;

/// Corner numbers of subtriangle k: two vertices of the triangle and 3 for the centroid.
std::array<int, 3> subtriangle(int k) { return {(k + 1) % 3, (k + 2) % 3, 3}; }

/// Adds factor * (sigma n) at one corner to two rows of the conditions.
void add_traction(MatrixXd& conditions, int row, int k, int corner,
                  const Vector2d& n, double factor) {
  const int first = 9 * k + 3 * corner;
  conditions(row, first) += factor * n.x();
  conditions(row, first + 2) += factor * n.y();
  conditions(row + 1, first + 1) += factor * n.y();
  conditions(row + 1, first + 2) += factor * n.x();
}

/// f on subtriangle k from the moments int f phi_i: the mean of phi_i over subtriangle k
/// is 1/9 for i = k and 4/9 otherwise.
Matrix3d force_per_moment(double area) {
  Matrix3d means = Matrix3d::Constant(4.0 / 9);
  means.diagonal().setConstant(1.0 / 9);
  return (area / 3 * means).inverse();
}

/// The conditions of the header on a triangle, conditions * stress = right * loads, as
/// tractions: divergences times the root of the area, jumps of unit normals, moments over
/// lengths.
struct StressConditions {
  MatrixXd matrix = MatrixXd::Zero(30, 27),
           right = MatrixXd::Zero(30, all_loads);

  explicit StressConditions(const TriangleCorners& corners) {
    x_ << corners, corners.rowwise().mean();
    twice_area_ =
        turned_right(x_.col(2) - x_.col(0)).dot(x_.col(1) - x_.col(0));
    int row = 0;
    for (int k = 0; k < 3; ++k, row += 2) add_divergence(row, k);
    for (int vertex = 0; vertex < 3; ++vertex, row += 4)
      add_continuity(row, vertex);
    for (int k = 0; k < 3; ++k, row += 4) add_edge(row, k);
  }

 private:
  double root_of_area() const { return std::sqrt(twice_area_ / 2); }

  /// div sigma = sum of sigma grad(phi) = -f in subtriangle k.
  void add_divergence(int row, int k) {
    const TriangleCorners corners = x_(Eigen::all, subtriangle(k));
    for (int c = 0; c < 3; ++c) {
      const Vector2d gradient =
          -turned_right(side_of(corners, c)) / (twice_area_ / 3);
      add_traction(matrix, row, k, c, gradient, root_of_area());
    }
    add_body_force(row, k);
  }

  void add_body_force(int row, int k) {
    const Matrix3d forces = root_of_area() * force_per_moment(twice_area_ / 2);
    for (int i = 0; i < 3; ++i)
      right(row, loads_on_edges + 2 * i) =
          right(row + 1, loads_on_edges + 2 * i + 1) = -forces(k, i);
  }

  /// Continuity on the edge from a vertex to the centroid, at both ends.
  void add_continuity(int row, int vertex) {
    const Vector2d n = turned_right(x_.col(3) - x_.col(vertex)).normalized();
    // the two subtriangles that have this vertex
    const int before = (vertex + 2) % 3, after = (vertex + 1) % 3;
    for (int end = 0; end < 2; ++end, row += 2)
      for (int k : {before, after}) {
        const int corner = end == 1 ? 2 : (subtriangle(k)[0] == vertex ? 0 : 1);
        add_traction(matrix, row, k, corner, n, k == before ? 1 : -1);
      }
  }

  /// Moments b_i = l (2 F_i + F_j) / 6 on the outer edge k.
  void add_edge(int row, int k) {
    const Vector2d side = side_of(x_.leftCols<3>(), k),
                   n = turned_right(side).normalized();
    for (int end = 0; end < 2; ++end, row += 2) {
      add_traction(matrix, row, k, end, n, 2.0 / 6);
      add_traction(matrix, row, k, 1 - end, n, 1.0 / 6);
      right(row, 4 * k + 2 * end) = right(row + 1, 4 * k + 2 * end + 1) =
          1 / side.norm();
    }
  }

  Matrix<double, 2, 4> x_;
  double twice_area_;
};

/// The conditions on the reference triangle, solved for every unit load.
StressMap solve_reference_triangle() {
  const StressConditions conditions(reference_triangle());
  return least_squares_of_columns(conditions.matrix, conditions.right);
}

const StressMap& reference_map() {
  static const StressMap map = solve_reference_triangle();
  return map;
}

/// Integrals of products of corner values over a subtriangle of area A: A/12 (1 + delta).
double mass(double area, int a, int b) { return area / (a == b ? 6 : 12); }

/// Height over longest side below which Piola's map spoils the equilibrium: it carries
/// the rounding of the forces on the long edges over to the short one, where it grows
/// with the square of this ratio.
constexpr double thin = 0.06;

bool is_thin(const TriangleCorners& corners) {
  const double longest =
      largest_over(3, [&](int k) { return side_of(corners, k).squaredNorm(); });
  return piola_matrix(corners).determinant() < thin * longest;
}

using Loads = Matrix<double, all_loads, 1>;

/// Backward stable: what is left of each condition is of the size of rounding.
CompositeStress solved_directly(const TriangleCorners& corners,
                                const Loads& loads) {
  const StressConditions conditions(corners.colwise() -
                                    corners.rowwise().mean());
  const VectorXd stress =
      least_squares(conditions.matrix, conditions.right * loads);
  return Map<const CompositeStress>(stress.data());
}

/// Forces B^-1 forces on the reference triangle.
Loads pulled_back(Loads loads, const Matrix2d& B) {
  Map<Matrix<double, 2, all_loads / 2>> forces(loads.data());
  forces = (B.inverse() * forces).eval();
  return loads;
}

CompositeStress by_piola(const TriangleCorners& corners, const Loads& loads) {
  const Matrix2d B = piola_matrix(corners);
  const Matrix<double, 27, 1> s = reference_map() * pulled_back(loads, B);
  return piola_voigt(B) / B.determinant() *
         Map<const CompositeStress>(s.data());
}

}  // namespace

TriangleCorners reference_triangle() {
  TriangleCorners corners;
  corners << 0, 1, 0, 0, 0, 1;
  return corners;
}

Matrix2d piola_matrix(const TriangleCorners& corners) {
  Matrix2d B;
  B << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  return B;
}

Matrix3d piola_voigt(const Matrix2d& B) {
  const double a = B(0, 0), b = B(0, 1), c = B(1, 0), d = B(1, 1);
  Matrix3d T;
  T << a * a, b * b, 2 * a * b,  //
      c * c, d * d, 2 * c * d,   //
      a * c, b * d, a * d + b * c;
  return T;
}

CompositeStress composite_stress(const TriangleCorners& corners,
                                 const EdgeLoads& on_edges,
                                 const BodyLoads& body_loads) {
  Loads loads;
  loads << on_edges, body_loads;
  return is_thin(corners) ? solved_directly(corners, loads)
                          : by_piola(corners, loads);
}

Matrix<double, 2, 3> body_force_of(const BodyLoads& body_loads, double area) {
  return Map<const Matrix<double, 2, 3>>(body_loads.data()) *
         force_per_moment(area).transpose();
}

double energy(const TriangleCorners& corners, const Matrix3d& compliance,
              const CompositeStress& stress) {
  const double area = piola_matrix(corners).determinant() / 6;
  const CompositeStress strain = compliance * stress;
  double sum = 0;
  for (int k = 0; k < 9; k += 3)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        sum += mass(area, a, b) * stress.col(k + a).dot(strain.col(k + b));
  return sum;
}

Vector4d density_of_moments(const Vector4d& moments, double length) {
  Vector4d density;
  density << 2 * moments.head<2>() - moments.tail<2>(),
      2 * moments.tail<2>() - moments.head<2>();
  return 2 / length * density;
}

Vector4d moments_of_density(const Vector4d& density, double length) {
  Vector4d moments;
  moments << 2 * density.head<2>() + density.tail<2>(),
      2 * density.tail<2>() + density.head<2>();
  return length / 6 * moments;
}

}  // namespace ffcontact
