// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/free_displacement.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

using Vector6d = VoigtVector<3>;

HookeTensors<3> everywhere(const SolidMesh& mesh, const VoigtMatrix<3>& C) {
  return HookeTensors<3>(mesh.cell_count(), C);
}

/// A symmetric tensor in Voigt's order with engineering shear.
Vector6d engineering(const Matrix3d& e) {
  Vector6d voigt;
  voigt << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
  return voigt;
}

VoigtMatrix<3> random_tensor(Random& random) {
  const MatrixXd root = random_matrix(6, 6, random);
  return root * root.transpose() + VoigtMatrix<3>::Identity();
}

Matrix3d random_rotation(Random& random) {
  return Eigen::AngleAxisd(1.2, Vector3d(random_vector(3, random)).normalized())
      .toRotationMatrix();
}

/// A body as FreeFEM assembles it.
struct SolidProblem {
  SolidMesh mesh;
  RowMatrix A;
  VectorXd b;

  SolidProblem(const SolidMesh& m, const HookeTensors<3>& hooke)
      : mesh(m), A(stiffness(m, hooke)), b(VectorXd::Zero(A.rows())) {}

  void prescribe(int vertex, int component, double value) {
    const int dof = 3 * vertex + component;
    A.coeffRef(dof, dof) = 1e30;
    b[dof] = 1e30 * value;
  }
  VectorXd solved() const { return displacement(elastic_system(A, b, 3)); }
};

TEST(SolidHooke, isotropic_is_lambda_trace_plus_two_G_strain) {
  Matrix3d e;
  e << 0.3, 0.1, -0.4,  //
      0.1, -0.2, 0.5,   //
      -0.4, 0.5, 0.7;
  const Matrix3d sigma = 7 * e.trace() * Matrix3d::Identity() + 2 * 5 * e;
  Vector6d expected;
  expected << sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(1, 2), sigma(0, 2),
      sigma(0, 1);
  EXPECT_LT((isotropic<3>(7, 5) * engineering(e) - expected).norm(), 1e-14);
}

TEST(SolidHooke, traction_is_stress_times_normal) {
  Vector6d s;
  s << 1, 2, 3, 4, 5, 6;
  Matrix3d sigma;
  sigma << 1, 6, 5, 6, 2, 4, 5, 4, 3;
  const Vector3d n(7, 8, 9);
  EXPECT_EQ(traction(s, n), Vector3d(sigma * n));
}

RC_GTEST_PROP(SolidHooke,
              strain_of_a_linear_displacement_is_its_symmetric_gradient,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Matrix3d grad = random_matrix(3, 3, random);
  const VectorXd u = nodal_values(
      mesh, [&](const Vector3d& x) -> Vector3d { return grad * x; });
  const Vector6d expected = engineering(0.5 * (grad + grad.transpose()));
  const HookeTensors<3> hooke = everywhere(mesh, random_tensor(random));
  const Matrix<double, 6, Dynamic> sigma = stresses(mesh, hooke, u);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    RC_ASSERT((strain(mesh, u, t) - expected).norm() < 1e-11);
    RC_ASSERT((sigma.col(t) - hooke[t] * expected).norm() < 1e-10);
  }
}

TEST(SolidHooke, refuses_a_tensor_that_is_not_elliptic) {
  const auto refusal_of = [](const VoigtMatrix<3>& C) {
    return refusal([&] {
      require_elliptic(HookeTensors<3>{isotropic<3>(1, 1), C}, 2);
    });
  };
  const std::string sentence =
      "Hooke's tensor on tetrahedron 1 is not symmetric and positive definite";
  EXPECT_EQ(refusal_of(isotropic<3>(1, 2)), "accepted");
  EXPECT_EQ(refusal_of(isotropic<3>(-2, 3.1)), "accepted");
  EXPECT_EQ(refusal_of(isotropic<3>(-2, 2.9)), sentence);
  EXPECT_EQ(refusal_of(isotropic<3>(1, 0)), sentence);
}

RC_GTEST_PROP(SolidStiffness,
              is_symmetric_and_has_the_rigid_motions_in_its_kernel,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const MatrixXd K = stiffness(mesh, everywhere(mesh, random_tensor(random)));
  const double scale = K.cwiseAbs().maxCoeff();
  RC_ASSERT((K - K.transpose()).cwiseAbs().maxCoeff() <= 1e-14 * scale);
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = Vector3d::Unit(k);
    const VectorXd shift =
        nodal_values(mesh, [&](const Vector3d&) -> Vector3d { return axis; });
    const VectorXd turn = nodal_values(
        mesh, [&](const Vector3d& x) -> Vector3d { return axis.cross(x); });
    RC_ASSERT((K * shift).cwiseAbs().maxCoeff() < 1e-13 * scale);
    RC_ASSERT((K * turn).cwiseAbs().maxCoeff() < 1e-12 * scale);
  }
}

TEST(SolidStiffness, has_no_kernel_but_the_rigid_motions) {
  Random random(3);
  const SolidMesh mesh = irregular_solid(random);
  const MatrixXd K = stiffness(mesh, everywhere(mesh, isotropic<3>(3, 2)));
  const VectorXd values =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(K).eigenvalues();
  EXPECT_LT(values[5], 1e-12 * values.maxCoeff());
  EXPECT_GT(values[6], 1e-4 * values.maxCoeff());
}

RC_GTEST_PROP(SolidStiffness,
              energy_of_a_linear_displacement_is_volume_times_density,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  const Matrix3d grad = random_matrix(3, 3, random);
  const VoigtMatrix<3> C = random_tensor(random);
  const VectorXd u = nodal_values(
      mesh, [&](const Vector3d& x) -> Vector3d { return grad * x; });
  const Vector6d e = engineering(0.5 * (grad + grad.transpose()));
  const double energy = u.dot(stiffness(mesh, everywhere(mesh, C)) * u) / 2;
  const double expected = 12 * e.dot(C * e) / 2;
  RC_ASSERT(std::abs(energy - expected) < 1e-12 * expected);
}

RC_GTEST_PROP(SolidStiffness,
              energy_is_the_same_when_body_and_displacement_turn,
              (Random random)) {
  const SolidMesh mesh = irregular_solid(random);
  SolidMesh turned = mesh;
  const Matrix3d R = random_rotation(random);
  turned.vertices = R * mesh.vertices;
  const VectorXd u = random_vector(3 * mesh.vertex_count(), random);
  VectorXd turned_u(u.size());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    turned_u.segment<3>(3 * v) = R * u.segment<3>(3 * v);
  const HookeTensors<3> hooke = everywhere(mesh, isotropic<3>(3, 2));
  const double energy = u.dot(stiffness(mesh, hooke) * u),
               turned_energy =
                   turned_u.dot(stiffness(turned, hooke) * turned_u);
  RC_ASSERT(std::abs(turned_energy - energy) < 1e-12 * energy);
}

RC_GTEST_PROP(SolidSystem, prescribed_linear_displacements_go_on_inside,
              (Random random)) {
  const SolidMesh mesh =
      shuffled(moved(brick({3, 3, 3}, {3, 3, 3}), 1, 0.15, random), random);
  const Matrix3d grad = random_matrix(3, 3, random);
  const VectorXd exact = nodal_values(
      mesh, [&](const Vector3d& x) -> Vector3d { return grad * x; });
  SolidProblem problem(mesh, everywhere(mesh, random_tensor(random)));
  for (int label = low_x; label <= high_z; ++label)
    for (int v : vertices_on(mesh, label))
      for (int c = 0; c < 3; ++c) problem.prescribe(v, c, exact[3 * v + c]);
  const ElasticSystem system = elastic_system(problem.A, problem.b, 3);
  RC_ASSERT(std::count(system.prescribed.begin(), system.prescribed.end(), 0) ==
            3 * 8);
  RC_ASSERT((displacement(system) - exact).norm() < 1e-12 * exact.norm());
}

TEST(SolidSystem, a_pulled_brick_stretches_and_gets_thinner) {
  constexpr double E = 200, nu = 0.3, p = 5;
  Random random(7);
  const SolidMesh mesh = irregular_solid(random);
  SolidProblem problem(
      mesh, everywhere(mesh, isotropic<3>(E * nu / ((1 + nu) * (1 - 2 * nu)),
                                          E / (2 * (1 + nu)))));
  for (int c = 0; c < 3; ++c)
    for (int v : vertices_on(mesh, low_x + 2 * c)) problem.prescribe(v, c, 0);
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    if (mesh.boundary_label[f] != high_z) continue;
    const Matrix3d x = mesh.vertices(Eigen::all, mesh.boundary.col(f));
    for (int v : mesh.boundary.col(f))
      problem.b[3 * v + 2] += p * facet_vector(x).norm() / 3;
  }
  const VectorXd exact = nodal_values(mesh, [&](const Vector3d& x) -> Vector3d {
    return p / E * Vector3d(-nu * x.x(), -nu * x.y(), x.z());
  });
  EXPECT_LT((problem.solved() - exact).norm(), 1e-12 * exact.norm());
}

TEST(SolidSystem, refuses_a_matrix_of_another_dimension) {
  EXPECT_EQ(
      refusal([] { elastic_system(RowMatrix(4, 4), Vector4d::Zero(), 3); }),
      "A has 4 rows, no multiple of the dimension 3");
}

TEST(SolidSystem, is_not_joined_with_a_plane_body) {
  RowMatrix unit(6, 6);
  unit.setIdentity();
  const VectorXd b = VectorXd::Zero(6);
  const ElasticSystem plane = elastic_system(unit, b),
                      solid = elastic_system(unit, b, 3);
  EXPECT_EQ(joined_systems({solid, solid}).dimension, 3);
  EXPECT_EQ(refusal([&] {
              joined_systems({solid, plane});
            }),
            "a plane body and a solid in one system");
}

}  // namespace
}  // namespace ffcontact
