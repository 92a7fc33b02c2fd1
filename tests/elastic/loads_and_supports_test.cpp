// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/loads_and_supports.hpp"

#include <gtest/gtest.h>

#include "ffcontact/elastic/elastic_system.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/refusals.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Tractions on two sides and supports on a third one, found again.
template <int dim>
void expect_found_again(const SimplexMesh<dim>& mesh,
                        const HookeTensors<dim>& hooke, double area_of_2,
                        double area_of_3) {
  using Vector = Matrix<double, dim, 1>;
  const Vector on_2 = Vector::LinSpaced(1, 3), on_3 = -Vector::Ones();
  RowMatrix A = stiffness(mesh, hooke);
  VectorXd b = VectorXd::Zero(A.rows());
  Matrix<double, dim * dim, Dynamic> moments =
      Matrix<double, dim * dim, Dynamic>::Zero(dim * dim, mesh.boundary.cols());
  add_traction(mesh, 2, on_2, b, moments);
  add_traction(mesh, 3, on_3, b, moments);
  const Vector expected = area_of_2 * on_2 + area_of_3 * on_3,
               in_b = b.reshaped(dim, mesh.vertex_count()).rowwise().sum(),
               in_moments =
                   moments.reshaped(dim, moments.size() / dim).rowwise().sum();
  EXPECT_LT((in_b - expected).norm(), 1e-12);
  EXPECT_LT((in_moments - expected).norm(), 1e-12);
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    EXPECT_EQ(moments.col(f).isZero(0),
              mesh.boundary_label[f] != 2 && mesh.boundary_label[f] != 3);

  prescribe(mesh, 4, dim - 1, 0.5, A, b);
  const ElasticSystem system = elastic_system(A, b, dim);
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    if (mesh.boundary_label[f] == 4)
      for (const int v : mesh.boundary.col(f)) {
        EXPECT_EQ(system.prescribed_value[dim * v + dim - 1], 0.5);
      }
  EXPECT_EQ((system.prescribed_value.array() != 0).count(),
            std::count(system.prescribed.begin(), system.prescribed.end(), 1));
}

TEST(LoadsAndSupports, are_found_again) {
  const Mesh plane = rectangle(3, 2, 6, 4);
  expect_found_again(plane, Hooke(plane.cell_count(), isotropic(1, 2)), 4, 6);
  const SolidMesh solid = brick({3, 2, 2}, {6, 4, 5});
  expect_found_again(
      solid, HookeTensors<3>(solid.cell_count(), isotropic<3>(1, 2)), 20, 30);
}

TEST(LoadsAndSupports, name_what_does_not_fit) {
  const Mesh mesh = rectangle(3, 2, 6, 4);
  RowMatrix A(24, 24), other(22, 22);
  VectorXd b = VectorXd::Zero(24), few = VectorXd::Zero(22);
  Matrix4Xd moments = Matrix4Xd::Zero(4, mesh.boundary.cols()),
            no_moments(4, 0);
  const auto loaded = [&](int label, VectorXd& to, Matrix4Xd& with) {
    return refusal([&] { add_traction(mesh, label, {0, 1}, to, with); });
  };
  EXPECT_TRUE(says(loaded(7, b, moments), "label 7 is on no boundary edge"));
  EXPECT_TRUE(says(loaded(1, few, moments), "b"));
  EXPECT_TRUE(says(loaded(1, b, no_moments), "moments"));
  const auto held = [&](int label, int component, RowMatrix& of, VectorXd& to) {
    return refusal([&] { prescribe(mesh, label, component, 0, of, to); });
  };
  EXPECT_TRUE(says(held(7, 0, A, b), "label 7 is on no boundary edge"));
  EXPECT_TRUE(says(held(1, 2, A, b), "components 0 to 1, got 2"));
  EXPECT_TRUE(says(held(1, 0, other, b), "A"));
  EXPECT_TRUE(says(held(1, 0, A, few), "b"));
}

}  // namespace
}  // namespace ffcontact
