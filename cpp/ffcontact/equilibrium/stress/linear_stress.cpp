// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/linear_stress.hpp"

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/linear/norms.hpp"
#include "ffcontact/mesh/edges.hpp"

namespace ffcontact {

namespace {

/// Values of a constant stress differ by less than this part of the largest.
constexpr double rounding = 1e-14;

}  // namespace

LinearStresses LinearStresses::of_values(
    const Ref<const Matrix<double, 9, Dynamic>>& values) {
  LinearStresses result;
  result.mean =
      (values.topRows<3>() + values.middleRows<3>(3) + values.bottomRows<3>()) /
      3;
  result.variation = values - result.mean.replicate<3, 1>();
  if (max_norm(result.variation) <= rounding * max_norm(values))
    result.variation.resize(9, 0);
  return result;
}

Matrix3d LinearStresses::at_vertices(int triangle) const {
  Matrix3d values = mean.col(triangle).replicate<1, 3>();
  if (varies()) values += variation.col(triangle).reshaped(3, 3);
  return values;
}

LinearStresses operator+(LinearStresses a, const LinearStresses& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  a.mean += b.mean;
  if (!a.varies())
    a.variation = b.variation;
  else if (b.varies())
    a.variation += b.variation;
  return a;
}

CompositeStress composite_of(const Matrix3d& at_vertices) {
  CompositeStress values;
  const Vector3d middle = at_vertices.rowwise().mean();
  for (int k = 0; k < 3; ++k)
    values.middleCols<3>(3 * k) << at_vertices.col((k + 1) % 3),
        at_vertices.col((k + 2) % 3), middle;
  return values;
}

EdgeLoads edge_loads(const TriangleCorners& corners,
                     const Matrix3d& at_vertices) {
  EdgeLoads loads;
  for (int k = 0; k < 3; ++k) {
    const Vector2d normal = turned_right(side_of(corners, k));
    Vector4d tractions;  // times the length of the side
    tractions << traction(at_vertices.col((k + 1) % 3), normal),
        traction(at_vertices.col((k + 2) % 3), normal);
    loads.segment<4>(4 * k) = moments_of_density(tractions, 1);
  }
  return loads;
}

BodyLoads balancing_loads(const TriangleCorners& corners,
                          const Matrix3d& at_vertices) {
  Vector2d twice_divergence = Vector2d::Zero();  // times the area
  for (int k = 0; k < 3; ++k)
    twice_divergence -=
        traction(at_vertices.col(k), turned_right(side_of(corners, k)));
  const Vector2d at_vertex = -twice_divergence / 6;
  return at_vertex.replicate<3, 1>();
}

}  // namespace ffcontact
