// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/splitting/quadrangle_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace ffcontact {

namespace {

/// Lengths, or fractions of an area, that differ by less are equal.
constexpr double rounding_of_diagonals = 1e-9;

using Quadrangle = Matrix<double, 3, 4>;

/// The corners from that of the lowest number on, towards its lower neighbour.
Vector4i in_order_of_numbers(const Vector4i& numbers) {
  int lowest = 0;
  numbers.minCoeff(&lowest);
  Vector4i order;
  for (int k = 0; k < 4; ++k) order[k] = (lowest + k) % 4;
  if (numbers[order[3]] < numbers[order[1]]) std::swap(order[1], order[3]);
  return order;
}

/// Whether the diagonal from corner `from` on leaves a part of the area on each side.
bool is_inside(const Quadrangle& x, int from) {
  const Vector3d start = x.col(from);
  const Vector3d diagonal = x.col((from + 2) % 4) - start;
  const Vector3d one = (x.col(from + 1) - start).cross(diagonal);
  const Vector3d other = diagonal.cross(x.col((from + 3) % 4) - start);
  const Vector3d whole = one + other;
  return std::min(one.dot(whole), other.dot(whole)) >
         rounding_of_diagonals * whole.squaredNorm();
}

double diagonal_length(const Quadrangle& x, int from) {
  return (x.col(from + 2) - x.col(from)).norm();
}

bool is_flat(const Quadrangle& x) {
  const Vector3d one = x.col(2) - x.col(0), other = x.col(3) - x.col(1);
  const double longest = std::max(one.norm(), other.norm());
  return one.cross(other).norm() / 2 <= flat_body * longest * longest;
}

/// Whether the diagonal through corner 0 cuts; the other does if not; nothing if none.
std::optional<bool> cuts_at_first(const Quadrangle& x) {
  if (is_flat(x)) return std::nullopt;
  const bool first = is_inside(x, 0), second = is_inside(x, 1);
  if (!first && !second) return std::nullopt;
  if (first != second) return first;
  return diagonal_length(x, 0) <=
         (1 + rounding_of_diagonals) * diagonal_length(x, 1);
}

}  // namespace

std::optional<std::array<Vector3i, 2>> quadrangle_triangles(
    const Quadrangle& corners, const Vector4i& numbers) {
  const Vector4i order = in_order_of_numbers(numbers);
  const auto at_first = cuts_at_first(corners(Eigen::all, order));
  if (!at_first) return std::nullopt;
  const int a = (order[0] + (*at_first ? 0 : 1)) % 4;
  const int b = (a + 1) % 4, c = (a + 2) % 4, d = (a + 3) % 4;
  return std::array<Vector3i, 2>{Vector3i(a, b, c), Vector3i(a, c, d)};
}

}  // namespace ffcontact
