// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/energy/facet_energy.hpp"
#include "support/tetrahedra.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A stress that is linear over the whole tetrahedron, Voigt: S (1, x, y, z).
struct LinearSolidStress {
  Matrix<double, 6, 4> S;
  Matrix<double, 6, 1> at(const Vector3d& x) const {
    return S * Vector4d(1, x.x(), x.y(), x.z());
  }
  Vector3d body_force() const {
    return -(traction(S.col(1), Vector3d::Unit(0)) +
             traction(S.col(2), Vector3d::Unit(1)) +
             traction(S.col(3), Vector3d::Unit(2)));
  }
  SolidStress values(const TetrahedronCorners& x) const {
    SolidStress stress;
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < 3; ++j)
        stress.col(4 * k + j) = at(x.col((k + 1 + j) % 4));
      stress.col(4 * k + 3) = at(x.rowwise().mean());
    }
    return stress;
  }
};

/// Columns: a linear function of the 96 coefficients for each of them.
template <class Function>
MatrixXd matrix_of(const Function& function) {
  MatrixXd result(function(SolidStress::Zero()).size(), 96);
  for (int unit = 0; unit < 96; ++unit) {
    SolidStress stress = SolidStress::Zero();
    stress.reshaped()[unit] = 1;
    result.col(unit) = function(stress).reshaped();
  }
  return result;
}

MatrixXd stacked(const MatrixXd& above, const MatrixXd& below) {
  MatrixXd result(above.rows() + below.rows(), above.cols());
  result << above, below;
  return result;
}

RC_GTEST_PROP(JohnsonMercier, has_the_dimensions_of_the_theory,
              (Random random)) {
  const TetrahedronCorners x = random_tetrahedron(random);
  const MatrixXd jumps = matrix_of(
                     [&](const SolidStress&s) { return inner_jumps(x, s); }),
                 divergence = matrix_of(
                     [&](const SolidStress&s) { return divergences(x, s); }),
                 loads = matrix_of([&](const SolidStress&s) {
                   return facet_loads_of<3>(x, s);
                 });
  MatrixXd differences = divergence.bottomRows(9);
  for (int k = 0; k < 3; ++k)
    differences.middleRows(3 * k, 3) -= divergence.topRows(3);

  const auto kernel = [](const MatrixXd& conditions) {
    Eigen::FullPivLU<MatrixXd> lu(conditions);
    lu.setThreshold(1e-10);
    return lu.dimensionOfKernel();
  };
  RC_ASSERT(kernel(jumps) == 42);
  RC_ASSERT(kernel(stacked(jumps, divergence)) == 30);
  RC_ASSERT(kernel(stacked(jumps, loads)) == 6);
  RC_ASSERT(kernel(stacked(stacked(jumps, loads), differences)) == 0);
}

RC_GTEST_PROP(JohnsonMercier, is_in_equilibrium_with_balanced_loads,
              (Random random)) {
  const TetrahedronCorners x = random_tetrahedron(random);
  const SolidLoads loads = balanced_solid_loads(x, random);
  const SolidStress stress = composite_stress(x, loads.on_faces, loads.in_body);
  const double scale = stress.cwiseAbs().maxCoeff();
  const Matrix<double, 3, 4> f =
      body_force_of(loads.in_body, piola_matrix(x).determinant() / 6);
  RC_ASSERT((divergences(x, stress) + f).norm() < 1e-11 * scale);
  RC_ASSERT(inner_jumps(x, stress).norm() < 1e-11 * scale);
  RC_ASSERT((facet_loads_of<3>(x, stress) - loads.on_faces).norm() <
            1e-11 * scale);
}

RC_GTEST_PROP(JohnsonMercier, has_linear_stresses, (Random random)) {
  const TetrahedronCorners x = random_tetrahedron(random);
  const LinearSolidStress linear{random_matrix(6, 4, random)};
  const SolidStress expected = linear.values(x);
  const double volume = piola_matrix(x).determinant() / 6;
  const SolidBodyLoads in_body =
      (volume / 4 * linear.body_force()).replicate<1, 4>();
  const FaceLoads on_faces = facet_loads_of<3>(x, expected);
  RC_ASSERT((balancing_body_loads(on_faces) - in_body).norm() < 1e-13);
  RC_ASSERT((composite_stress(x, on_faces, in_body) - expected).norm() < 1e-11);
}

RC_GTEST_PROP(JohnsonMercier, body_force_has_its_moments, (Random random)) {
  // phi_i has the mean 1/16 over subtetrahedron i and 5/16 over the others.
  const SolidBodyLoads loads = random_matrix(3, 4, random);
  const Matrix<double, 3, 4> f = body_force_of(loads, 2);
  for (int i = 0; i < 4; ++i) {
    const Vector3d moment =
        0.5 * (5.0 / 16 * f.rowwise().sum() - 4.0 / 16 * f.col(i));
    RC_ASSERT((moment - loads.col(i)).norm() < 1e-13);
  }
}

TEST(JohnsonMercier, energy_of_a_constant_stress_is_volume_times_density) {
  const TetrahedronCorners x = 2 * reference_cell<3>();  // 8/6 mm^3
  const Matrix<double, 6, 6> C = isotropic<3>(3, 2);
  Matrix<double, 6, 1> sigma;
  sigma << 1, 2, 3, 4, 5, 6;
  const double density = sigma.dot(C.inverse() * sigma);
  EXPECT_NEAR(energy(x, C.inverse(), sigma.replicate<1, 16>()),
              8.0 / 6 * density, 1e-12);
}

TEST(JohnsonMercier, energy_of_a_linear_stress) {
  // sigma_xx = x on the reference tetrahedron: int x^2 = 2 / 5!
  LinearSolidStress linear{Matrix<double, 6, 4>::Zero()};
  linear.S(0, 1) = 1;
  Matrix<double, 6, 6> compliance = Matrix<double, 6, 6>::Identity();
  const TetrahedronCorners x = reference_cell<3>();
  EXPECT_NEAR(energy(x, compliance, linear.values(x)), 2.0 / 120, 1e-15);
}

TEST(JohnsonMercier, moments_and_densities_are_inverse) {
  Random random(3);
  const Matrix3d density = random_matrix(3, 3, random);
  const Matrix3d moments = face_moments_of(density, 2);
  EXPECT_LT((face_density(moments, 2) - density).norm(), 1e-14);
  // the whole force is area times mean
  EXPECT_LT((moments.rowwise().sum() - 2 * density.rowwise().mean()).norm(),
            1e-14);
}

/// A tetrahedron with any elastic law, and any columns of loads.
struct AnyForm {
  TetrahedronCorners x;
  Matrix<double, 6, 6> compliance;
  std::array<Matrix9d, 4> basis;

  explicit AnyForm(std::mt19937& random) : x(random_tetrahedron(random)) {
    const MatrixXd root = random_matrix(6, 6, random);
    compliance = root * root.transpose() + 0.2 * MatrixXd::Identity(6, 6);
    for (Matrix9d& columns : basis) columns = random_matrix(9, 9, random);
  }
  SolidStress stress(const Matrix<double, 36, 1>& unknowns) const {
    FaceLoads loads;
    for (int k = 0; k < 4; ++k)
      loads.middleCols<3>(3 * k).reshaped() =
          basis[k] * unknowns.segment<9>(9 * k);
    return composite_stress(x, loads, balancing_body_loads(loads));
  }
};

RC_GTEST_PROP(FaceEnergy, is_that_of_the_composite_stress, (Random random)) {
  const AnyForm any(random);
  const CellForm<3> H = facet_energy<3>(any.x, any.compliance, any.basis);
  const Matrix<double, 36, 1> unknowns = random_vector(36, random);
  const double expected = energy(any.x, any.compliance, any.stress(unknowns));
  RC_ASSERT(std::abs(unknowns.dot(H * unknowns) - expected) < 1e-11 * expected);
}

RC_GTEST_PROP(FaceEnergy, slope_is_that_of_the_energy, (Random random)) {
  const AnyForm any(random);
  const Matrix<double, 36, 1> at = random_vector(36, random),
                              along = random_vector(36, random);
  const SolidStress sigma = any.stress(at), tau = any.stress(along);
  const double slope =
      facet_slope<3>(any.x, any.compliance, sigma, any.basis).dot(along);
  // (sigma + tau)^2 - (sigma - tau)^2 = 4 sigma tau
  const double plus = energy(any.x, any.compliance, sigma + tau),
               minus = energy(any.x, any.compliance, sigma - tau);
  RC_ASSERT(std::abs(slope - (plus - minus) / 4) < 1e-11 * (plus + minus));
}

}  // namespace
}  // namespace ffcontact
