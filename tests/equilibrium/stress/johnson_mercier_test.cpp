// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

#include <gtest/gtest.h>

#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "support/cells.hpp"

namespace ffcontact {
namespace {

using namespace test;

template <int d>
double defect(const CellCorners<d>& x, const Loads<d>& loads,
              const SubcellStress<d>& stress) {
  return cell_defect<d>(x, stress, loads.on_facets, loads.in_body).largest() /
         stress.cwiseAbs().maxCoeff();
}

template <int d>
SubcellStress<d> stress_of(const CellCorners<d>& x, const Loads<d>& loads) {
  return composite_stress<d>(x, loads.on_facets, loads.in_body);
}

template <int d>
double defect_with_balanced_loads(const CellCorners<d>& x, Random& random) {
  const Loads<d> loads = balanced_loads<d>(x, random);
  return defect<d>(x, loads, stress_of<d>(x, loads));
}

RC_GTEST_PROP(JohnsonMercier, is_in_equilibrium_with_balanced_loads,
              (Random random)) {
  RC_ASSERT(defect_with_balanced_loads<2>(random_cell<2>(random), random) <
            1e-11);
  RC_ASSERT(defect_with_balanced_loads<3>(random_cell<3>(random), random) <
            1e-11);
}

/// With the loads of a stress of size 1: balanced ones that know nothing of the height would
/// have a stress that is as large as the cell is thin, and hide what is left.
template <int d>
double defect_of_thin_cell(double height, Random& random) {
  CellCorners<d> x = reference_cell<d>();
  x.col(d).fill(1);
  x(d - 1, d) = height;
  const Loads<d> loads = LinearStress<d>(random).loads(x);
  return cell_defect<d>(x, stress_of<d>(x, loads), loads.on_facets,
                        loads.in_body)
      .largest();
}

RC_GTEST_PROP(JohnsonMercier, is_in_equilibrium_on_thin_cells,
              (Random random)) {
  const double height = *rc::gen::element(0.0174, 5e-3, 1e-3, 1e-4);
  RC_ASSERT(defect_of_thin_cell<2>(height, random) < 1e-13);
  RC_ASSERT(defect_of_thin_cell<3>(height, random) < 1e-10);
}

/// By Piola's map rounding grows with the square of the aspect: by 9.4e-15 at most in a million
/// samples under Prescott's kernel of OpenBLAS, by 6.1e-15 under Haswell's.
RC_GTEST_PROP(JohnsonMercier, keeps_its_digits_on_stretched_triangles,
              (Random random)) {
  const double height = *real(0.0177, 0.1);
  RC_ASSERT(defect_of_thin_cell<2>(height, random) <
            1.5e-14 / (height * height));
}

template <int d>
double error_of_linear_stress(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  const LinearStress<d> linear(random);
  return (stress_of<d>(x, linear.loads(x)) - linear.values(x)).norm();
}

RC_GTEST_PROP(JohnsonMercier, has_linear_stresses, (Random random)) {
  RC_ASSERT(error_of_linear_stress<2>(random) < 1e-11);
  RC_ASSERT(error_of_linear_stress<3>(random) < 1e-10);
}

template <int d>
double balancing_error(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  const Loads<d> loads = LinearStress<d>(random).loads(x);
  return (balancing_body_loads<d>(loads.on_facets) - loads.in_body).norm();
}

RC_GTEST_PROP(JohnsonMercier, balancing_loads_are_those_of_the_one_force,
              (Random random)) {
  RC_ASSERT(balancing_error<2>(random) < 1e-13);
  RC_ASSERT(balancing_error<3>(random) < 1e-13);
}

template <int d>
double defect_with_unbalanced_loads(Random& random) {
  const CellCorners<d> x = random_cell<d>(random);
  Loads<d> loads = balanced_loads<d>(x, random);
  loads.on_facets.reshaped()[random() % loads.on_facets.size()] += 0.1;
  return defect<d>(x, loads, stress_of<d>(x, loads));
}

RC_GTEST_PROP(JohnsonMercier, unbalanced_loads_give_a_stress_out_of_equilibrium,
              (Random random)) {
  RC_ASSERT(defect_with_unbalanced_loads<2>(random) > 1e-5);
  RC_ASSERT(defect_with_unbalanced_loads<3>(random) > 1e-5);
}

RC_GTEST_PROP(JohnsonMercier, energy_is_its_quadrature, (Random random)) {
  const CellCorners<2> x = random_cell<2>(random);
  const SubcellStress<2> stress = random_matrix(3, 9, random);
  const Matrix3d compliance = random_law<2>(random);
  // the middles of the sides integrate quadratic functions exactly
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      const Vector3d middle =
          0.5 * (stress.col(3 * k + c) + stress.col(3 * k + (c + 1) % 3));
      sum += volume_of(x) / 9 * middle.dot(compliance * middle);
    }
  RC_ASSERT(std::abs(energy<2>(x, compliance, stress) - sum) < 1e-13 * sum);
}

TEST(JohnsonMercier, energy_of_a_constant_stress_is_volume_times_density) {
  const CellCorners<3> x = 2 * reference_cell<3>();  // 8/6 mm^3
  const VoigtMatrix<3> C = isotropic<3>(3, 2);
  VoigtVector<3> sigma;
  sigma << 1, 2, 3, 4, 5, 6;
  const double density = sigma.dot(C.inverse() * sigma);
  EXPECT_NEAR(energy<3>(x, C.inverse(), sigma.replicate<1, 16>()),
              8.0 / 6 * density, 1e-12);
}

TEST(JohnsonMercier, energy_of_a_linear_stress) {
  // sigma_xx = x on the reference tetrahedron: int x^2 = 2 / 5!
  Random random(1);
  LinearStress<3> linear(random);
  linear.S.setZero();
  linear.S(0, 1) = 1;
  const CellCorners<3> x = reference_cell<3>();
  EXPECT_NEAR(energy<3>(x, VoigtMatrix<3>::Identity(), linear.values(x)),
              2.0 / 120, 1e-15);
}

}  // namespace
}  // namespace ffcontact
