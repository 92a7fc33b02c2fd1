// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/polynomial_stress.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/linear_stress.hpp"
#include "support/cells.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A displacement of degree 2 whose stress is linear: its edge tractions are linear and
/// its body force is constant.
struct Quadratic {
  Matrix<double, 2, 6> a;  ///< of 1, x, y, x^2, x y, y^2
  Matrix3d hooke;
  Vector3d stress(const Vector2d& x) const {
    const Vector2d dx = a.col(1) + 2 * x.x() * a.col(3) + x.y() * a.col(4);
    const Vector2d dy = a.col(2) + x.x() * a.col(4) + 2 * x.y() * a.col(5);
    return hooke * Vector3d(dx.x(), dy.y(), dx.y() + dy.x());
  }
  Vector2d body_force() const {
    const Vector3d o = stress({0, 0}), x = stress({1, 0}) - o,
                   y = stress({0, 1}) - o;
    return {-x[0] - y[2], -x[2] - y[1]};
  }
  Loads<2> loads(const CellCorners<2>& x) const {
    Loads<2> result;
    for (int k = 0; k < 3; ++k) {
      const Vector2d p = x.col((k + 1) % 3), q = x.col((k + 2) % 3),
                     side = q - p;
      const Vector2d n = Vector2d(side.y(), -side.x()).normalized();
      Matrix2d density;
      density << traction(stress(p), n), traction(stress(q), n);
      result.on_facets.middleCols<2>(2 * k) =
          facet_moments_of<2>(density, side.norm());
      result.in_body.col(k) = volume_of(x) / 3 * body_force();
    }
    return result;
  }
};

RC_GTEST_PROP(PolynomialStress,
              of_the_loads_of_a_quadratic_displacement_is_its_stress,
              (Random random)) {
  const CellCorners<2> corners = random_cell<2>(random);
  const Quadratic exact{random_matrix(2, 6, random), random_law<2>(random)};
  const Loads<2> loads = exact.loads(corners);
  const PolynomialStress stress =
      polynomial_stress(corners, exact.hooke, loads.on_facets, loads.in_body);
  for (int trial = 0; trial < 5; ++trial) {
    const Vector2d x = corners * (random_vector(3, random).cwiseAbs() / 3);
    RC_ASSERT((stress_at(stress, x) - exact.stress(x)).norm() < 1e-8);
  }
}

/// The composite stress fulfils what the polynomial one fulfils in the mean, and C eps(w)
/// has the least energy among these.
RC_GTEST_PROP(PolynomialStress, has_less_energy_than_the_composite_stress,
              (Random random)) {
  const CellCorners<2> corners = random_cell<2>(random);
  const Matrix3d hooke = random_law<2>(random);
  Loads<2> loads = balanced_loads<2>(corners, random);
  loads.in_body.setZero();
  const Matrix<double, 3, 12> balance =
      balance_conditions<2>(corners).leftCols<12>();
  loads.on_facets.reshaped() -= balance.transpose() *
                                (balance * balance.transpose()).inverse() *
                                balance * loads.on_facets.reshaped();
  const PolynomialStress stress =
      polynomial_stress(corners, hooke, loads.on_facets, loads.in_body);
  const Matrix3d compliance = hooke.inverse();
  const double composite =
      energy(corners, compliance,
             composite_stress(corners, loads.on_facets, loads.in_body));
  RC_ASSERT(energy(stress, Matrix3d::Zero()) <= composite * (1 + 1e-9));
}

RC_GTEST_PROP(PolynomialStress, energy_with_a_linear_stress_is_that_of_the_sum,
              (Random random)) {
  const CellCorners<2> corners = random_cell<2>(random);
  const Quadratic exact{random_matrix(2, 6, random), random_law<2>(random)};
  const Loads<2> loads = exact.loads(corners);
  const Matrix3d other = random_matrix(3, 3, random);
  const PolynomialStress stress =
      polynomial_stress(corners, exact.hooke, loads.on_facets, loads.in_body);
  const SubcellStress<2> sum =
      // linear here: the values tell it all
      corner_values(stress) + subcell_values<2>(other);
  const double expected = energy(corners, exact.hooke.inverse(), sum);
  RC_ASSERT(std::abs(energy(stress, other) - expected) < 1e-9 * (1 + expected));
}

RC_GTEST_PROP(PolynomialStress, turns_with_the_triangle, (Random random)) {
  const CellCorners<2> corners = random_cell<2>(random);
  const Matrix3d hooke = isotropic(*real(0, 5), 1);
  const Loads<2> loads = balanced_loads<2>(corners, random);
  const Matrix2d R = Eigen::Rotation2Dd(*real(-3, 3)).toRotationMatrix();
  const PolynomialStress before =
      polynomial_stress(corners, hooke, loads.on_facets, loads.in_body);
  const PolynomialStress after = polynomial_stress(
      R * corners, hooke, R * loads.on_facets, R * loads.in_body);
  const Vector2d x = corners.rowwise().mean(), n(0.6, 0.8);
  const Vector2d expected = R * traction(stress_at(before, x), n);
  RC_ASSERT((traction(stress_at(after, R * x), R * n) - expected).norm() <
            1e-8 * (1 + expected.norm()));
  const Matrix3d none = Matrix3d::Zero();
  RC_ASSERT(std::abs(energy(after, none) - energy(before, none)) <
            1e-9 * energy(before, none));
}

}  // namespace
}  // namespace ffcontact
