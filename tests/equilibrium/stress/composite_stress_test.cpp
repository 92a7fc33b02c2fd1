// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/composite_stress.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"
#include "support/balances.hpp"

namespace ffcontact {
namespace {

using namespace test;

double area(const TriangleCorners& x) {
  return cross(x.col(1) - x.col(0), x.col(2) - x.col(0)) / 2;
}

/// Corner c of subtriangle k: vertices k+1, k+2, centroid.
Vector2d corner(const TriangleCorners& x, int k, int c) {
  return c < 2 ? Vector2d(x.col((k + 1 + c) % 3)) : centroid(x);
}

/// A stress that is linear over the whole triangle, Voigt: S (1, x, y).
struct LinearStress {
  Matrix3d S;
  Vector3d at(const Vector2d& x) const { return S * Vector3d(1, x.x(), x.y()); }
  /// f = -div sigma
  Vector2d body_force() const {
    return {-S(0, 1) - S(2, 2), -S(2, 1) - S(1, 2)};
  }
  CompositeStress values(const TriangleCorners& x) const {
    CompositeStress stress;
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) stress.col(3 * k + c) = at(corner(x, k, c));
    return stress;
  }
  Loads loads(const TriangleCorners& x) const {
    Loads result;
    for (int k = 0; k < 3; ++k) {
      const Vector2d a = x.col((k + 1) % 3), b = x.col((k + 2) % 3),
                     side = b - a;
      const Vector2d n = Vector2d(side.y(), -side.x()).normalized();
      Vector4d density;
      density << traction(at(a), n), traction(at(b), n);
      result.on_edges.segment<4>(4 * k) =
          moments_of_density(density, side.norm());
      result.in_body.segment<2>(2 * k) = area(x) / 3 * body_force();
    }
    return result;
  }
};

/// The defect on the mesh of this one triangle, whose whole boundary is known.
EquilibriumDefect defect(const TriangleCorners& corners, const Loads& loads,
                         const CompositeStress& stress) {
  const Mesh mesh = single_triangle(corners);
  const Edges edges = edges_of(mesh);
  BoundaryTractions boundary;
  boundary.known.setConstant(2, 3, true);
  boundary.moments.resize(4, 3);
  for (int k = 0; k < 3; ++k)
    boundary.moments.col(edges.of_cell(k, 0)) =
        loads.on_edges.segment<4>(4 * k);
  return equilibrium_defect(mesh, edges, {stress}, loads.in_body, boundary);
}

RC_GTEST_PROP(CompositeStress, is_in_equilibrium_with_balanced_loads,
              (Random random)) {
  const TriangleCorners corners = random_triangle(random);
  const Loads loads = balanced_loads(corners, random);
  const CompositeStress stress =
      composite_stress(corners, loads.on_edges, loads.in_body);
  RC_ASSERT(defect(corners, loads, stress).largest() < 1e-11);
}

RC_GTEST_PROP(CompositeStress, is_in_equilibrium_on_thin_triangles,
              (Random random)) {
  TriangleCorners corners;
  corners << 0, 1, 1, 0, 0, *rc::gen::element(1e-2, 1e-3, 1e-4);
  const Loads loads = balanced_loads(corners, random);
  const CompositeStress stress =
      composite_stress(corners, loads.on_edges, loads.in_body);
  RC_ASSERT(defect(corners, loads, stress).largest() < 1e-11);
}

RC_GTEST_PROP(CompositeStress,
              reproduces_linear_stresses_and_constant_body_forces,
              (Random random)) {
  const TriangleCorners corners = random_triangle(random);
  const LinearStress linear{random_matrix(3, 3, random)};
  const Loads loads = linear.loads(corners);
  const CompositeStress stress =
      composite_stress(corners, loads.on_edges, loads.in_body);
  RC_ASSERT((stress - linear.values(corners)).cwiseAbs().maxCoeff() < 1e-11);
}

RC_GTEST_PROP(CompositeStress, every_spoiled_number_is_out_of_equilibrium,
              (Random random)) {
  const TriangleCorners corners = random_triangle(random);
  const Loads loads = balanced_loads(corners, random);
  CompositeStress stress =
      composite_stress(corners, loads.on_edges, loads.in_body);
  const int row = random() % 3, column = random() % 9;
  stress(row, column) += 1e-4;
  RC_ASSERT(defect(corners, loads, stress).largest() > 1e-7);
}

RC_GTEST_PROP(CompositeStress,
              unbalanced_loads_give_a_stress_out_of_equilibrium,
              (Random random)) {
  const TriangleCorners corners = random_triangle(random);
  Loads loads = balanced_loads(corners, random);
  loads.on_edges[random() % 12] += 0.1;
  const CompositeStress stress =
      composite_stress(corners, loads.on_edges, loads.in_body);
  RC_ASSERT(defect(corners, loads, stress).largest() > 1e-4);
}

RC_GTEST_PROP(CompositeStress, energy_is_its_quadrature, (Random random)) {
  const TriangleCorners x = random_triangle(random);
  const CompositeStress stress = random_matrix(3, 9, random);
  const Matrix3d compliance = random_law(random);
  double sum =
      0;  // the middles of the sides integrate quadratic functions exactly
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      const Vector3d middle =
          0.5 * (stress.col(3 * k + c) + stress.col(3 * k + (c + 1) % 3));
      sum += area(x) / 9 * middle.dot(compliance * middle);
    }
  RC_ASSERT(std::abs(energy(x, compliance, stress) - sum) < 1e-13 * sum);
}

RC_GTEST_PROP(CompositeStress, body_force_has_the_moments_it_was_made_from,
              (Random random)) {
  const TriangleCorners corners = random_triangle(random);
  const BodyLoads loads = random_vector(6, random);
  const Matrix<double, 2, 3> force = body_force_of(loads, area(corners));
  for (int i = 0; i < 3; ++i) {
    Vector2d moment = Vector2d::Zero();
    for (
        int k = 0; k < 3;
        // the mean of phi_i over subtriangle k is (1 + 1/3) / 3, opposite to vertex i
        // (1/3) / 3
        ++k)
      moment += area(corners) / 3 * (k == i ? 1.0 / 9 : 4.0 / 9) * force.col(k);
    RC_ASSERT((moment - loads.segment<2>(2 * i)).norm() < 1e-13);
  }
}

RC_GTEST_PROP(EdgeDensity, moments_and_densities_are_inverse_to_each_other,
              (Random random)) {
  const double length = *real(0.01, 100);
  const Vector4d density = random_vector(4, random);
  RC_ASSERT((density_of_moments(moments_of_density(density, length), length) -
             density)
                .norm() < 1e-14);
}

TEST(EdgeDensity, a_constant_density_has_half_its_resultant_at_each_end) {
  EXPECT_EQ(moments_of_density({3, -1, 3, -1}, 4), Vector4d(6, -2, 6, -2));
}

}  // namespace
}  // namespace ffcontact
