// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/elastic_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ffcontact/elastic/factor/condensed_stiffness.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/free_displacement.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// K, b and prescribed dofs before FreeFEM's boundary conditions.
struct Assembled {
  RowMatrix A;
  VectorXd b;
};

/// A row with nothing but its diagonal.
void empty_row(RowMatrix& A, int row, double diagonal) {
  for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
    entry.valueRef() = entry.col() == row ? diagonal : 0;
}

void empty_column(RowMatrix& A, int column) {
  for (Index row = 0; row < A.rows(); ++row)
    for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
      if (entry.col() == column && row != column) entry.valueRef() = 0;
}

/// FreeFEM's three ways to prescribe a dof: 1e30 penalises it, -1 empties its row, -2 its
/// row and column.
void prescribe(Assembled& system, int dof, double value, double tgv) {
  if (tgv > 0) {
    system.A.coeffRef(dof, dof) = tgv;
    system.b[dof] = tgv * value;
    return;
  }
  empty_row(system.A, dof, 1);
  system.b[dof] = value;
  if (tgv == -2) empty_column(system.A, dof);
}

/// A square whose left side is prescribed to `value`, pulled at the right.
Assembled pulled_square(double tgv, double value) {
  Problem problem = body(rectangle(3, 3, 3, 3), material(100, 0.3));
  add_traction(problem, right, {1, 0.5});
  Assembled system{problem.A, problem.b};
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (problem.mesh.vertices(0, v) == 0)
      for (int c = 0; c < 2; ++c)
        prescribe(system, 2 * v + c, (c + 1) * value, tgv);
  return system;
}

ElasticSystem read(const Assembled& system) {
  return elastic_system(system.A, system.b);
}

std::string refusal_of(const Assembled& system) {
  return refusal([&] { read(system); });
}

RC_GTEST_PROP(Stiffness, is_symmetric_and_has_the_rigid_motions_in_its_kernel,
              (Random random)) {
  const Mesh mesh = irregular(4, 3, 4, 3, random);
  const Hooke hooke(mesh.cell_count(), isotropic(3, 2));
  const RowMatrix K = stiffness(mesh, hooke);
  const auto residual = [&](const Field& motion) {
    return (K * nodal_values(mesh, motion)).cwiseAbs().maxCoeff();
  };
  const double scale = K.coeffs().cwiseAbs().maxCoeff();
  RC_ASSERT((MatrixXd(K) - MatrixXd(K).transpose()).cwiseAbs().maxCoeff() <=
            1e-15 * scale);
  RC_ASSERT(residual([](const Vector2d&) { return Vector2d(1, 0); }) <
            1e-13 * scale);
  RC_ASSERT(residual([](const Vector2d&) { return Vector2d(0, 1); }) <
            1e-13 * scale);
  RC_ASSERT(residual([](const Vector2d& x) {
              return Vector2d(-x.y(), x.x());
            }) < 1e-13 * scale);
}

RC_GTEST_PROP(Stiffness, is_the_energy_of_the_strains, (Random random)) {
  const Mesh mesh = irregular(3, 3, 3, 3, random);
  const Hooke hooke(mesh.cell_count(), isotropic(3, 2));
  const VectorXd u = random_vector(2 * mesh.vertices.cols(), random);
  double energy = 0;
  for (int t = 0; t < mesh.cell_count(); ++t)
    energy += signed_area(mesh, t) *
              strain(mesh, u, t).dot(hooke[t] * strain(mesh, u, t));
  RC_ASSERT(std::abs(u.dot(stiffness(mesh, hooke) * u) - energy) <
            1e-12 * energy);
}

TEST(ElasticSystem, tgv_of_1e30_and_minus_1_and_minus_2_are_read_alike) {
  const ElasticSystem reference = read(pulled_square(1e30, 0));
  for (double tgv : {-1.0, -2.0}) {
    const ElasticSystem system = read(pulled_square(tgv, 0));
    EXPECT_EQ(system.prescribed, reference.prescribed);
    EXPECT_EQ(system.prescribed_value, reference.prescribed_value);
    EXPECT_EQ(system.load, reference.load);
    EXPECT_LT(
        relative_difference(displacement(system), displacement(reference)),
        1e-14);
  }
}

TEST(ElasticSystem,
     prescribed_values_are_read_alike_from_tgv_of_1e30_and_minus_1) {
  const ElasticSystem penalised = read(pulled_square(1e30, 0.25)),
                      emptied = read(pulled_square(-1, 0.25));
  EXPECT_LT(
      relative_difference(emptied.prescribed_value, penalised.prescribed_value),
      1e-15);
  EXPECT_LT(relative_difference(emptied.load, penalised.load), 1e-14);
}

TEST(ElasticSystem, a_prescribed_motion_moves_the_body_rigidly) {
  const ElasticSystem fixed = read(pulled_square(1e30, 0)),
                      shifted = read(pulled_square(1e30, 0.25));
  const VectorXd by = displacement(shifted) - displacement(fixed);
  for (Index v = 0; v < by.size() / 2; ++v)
    EXPECT_LT((by.segment<2>(2 * v) - Vector2d(0.25, 0.5)).norm(), 1e-13);
}

TEST(ElasticSystem,
     free_dofs_carry_no_prescribed_value_and_prescribed_dofs_no_load) {
  for (double tgv : {1e30, 1e15, -1.0}) {
    const ElasticSystem system = read(pulled_square(tgv, 0.25));
    for (int dof = 0; dof < system.dof_count(); ++dof)
      EXPECT_EQ(system.prescribed[dof] ? system.load[dof]
                                       : system.prescribed_value[dof],
                0);
  }
}

TEST(JoinedSystems, move_each_as_by_itself) {
  const std::vector<ElasticSystem> bodies{read(pulled_square(1e30, 0.25)),
                                          read(pulled_square(-1, 0)),
                                          read(pulled_square(1e30, -0.5))};
  const ElasticSystem joined = joined_systems(bodies);
  ASSERT_EQ(joined.dof_count(), 3 * bodies[0].dof_count());
  const VectorXd all = displacement(joined);
  for (int k = 0; k < 3; ++k) {
    const VectorXd own = displacement(bodies[k]);
    EXPECT_LT(relative_difference(all.segment(k * own.size(), own.size()), own),
              1e-13);
  }
}

TEST(ElasticSystem, a_stiff_spring_is_no_prescribed_dof) {
  Assembled system = pulled_square(1e30, 0);
  system.A.coeffRef(10, 10) *= 1e6;
  EXPECT_FALSE(prescribed_dofs(system.A)[10]);
}

TEST(
    ElasticSystem,
    values_at_a_corner_whose_neighbours_are_all_prescribed_are_read_from_tgv_of_minus_1) {
  const Problem problem = body(rectangle(2, 2, 2, 2), material(100, 0.3));
  Assembled system{problem.A, problem.b};
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (problem.mesh.vertices.col(v) != Vector2d(1, 1))
      for (int c = 0; c < 2; ++c) prescribe(system, 2 * v + c, 0.1, -1);
  EXPECT_EQ(refusal_of(system), "accepted");
}

/// A square of 2 x 2 cells held all around but for the vertical dof of the middle of its
/// lower side, 2.
constexpr int only_free = 2 * 1 + 1;
Assembled held_but_for_one_dof(double tgv) {
  const Problem problem = body(rectangle(2, 2, 2, 2), material(100, 0.3));
  Assembled system{problem.A, problem.b};
  for (int dof = 0; dof < 2 * problem.mesh.vertex_count(); ++dof)
    if (dof != only_free) prescribe(system, dof, 0, tgv);
  return system;
}

TEST(ElasticSystem, a_free_dof_without_free_neighbours_is_free_with_every_tgv) {
  for (double tgv : {1e30, -1.0, -2.0}) {
    const std::vector<char> prescribed =
        prescribed_dofs(held_but_for_one_dof(tgv).A);
    for (int dof = 0; dof < 18; ++dof)
      EXPECT_EQ(prescribed[dof], dof != only_free)
          << "dof " << dof << ", tgv " << tgv;
  }
}

TEST(ElasticSystem,
     a_dof_penalised_where_tgv_of_minus_2_left_nothing_else_is_prescribed) {
  Assembled system = pulled_square(-2, 0);
  system.A.coeffRef(0, 0) = 1e30;
  EXPECT_TRUE(prescribed_dofs(system.A)[0]);
}

TEST(ElasticSystem, a_scaled_matrix_prescribes_the_same_dofs) {
  for (double tgv : {1e30, -1.0, -2.0}) {
    const RowMatrix scaled = 1e-3 * pulled_square(tgv, 0).A;
    EXPECT_EQ(prescribed_dofs(scaled), prescribed_dofs(pulled_square(tgv, 0).A))
        << "tgv " << tgv;
  }
}

TEST(ElasticSystem,
     refuses_a_scaled_matrix_that_leaves_open_which_dofs_are_free) {
  const Assembled system = held_but_for_one_dof(-2);
  const RowMatrix scaled = 0.5 * system.A;
  EXPECT_EQ(refusal([&] { elastic_system(scaled, system.b); }),
            "dof 0 has nothing but its diagonal 0.5 in A, others have another "
            "value, and "
            "none is 1: which of them are "
            "prescribed "
            "cannot be told; assemble A and b with tgv=-1 or the default tgv");
}

TEST(ElasticSystem, refuses_prescribed_values_whose_columns_are_gone) {
  EXPECT_EQ(refusal_of(pulled_square(-2, 0.25)),
            "dof 0 is prescribed to 0.25 but its column of A is gone: assemble "
            "A and b "
            "with tgv=-1 or the default tgv");
}

TEST(ElasticSystem, refuses_numbers_that_are_not_finite) {
  Assembled system = pulled_square(1e30, 0);
  system.b[5] = std::nan("");
  EXPECT_EQ(refusal_of(system), "b[5] is nan, not a finite number");
  system = pulled_square(1e30, 0);
  system.A.coeffRef(4, 5) = std::nan("");
  EXPECT_EQ(refusal_of(system), "A(4,5) is nan, not finite");
}

TEST(ElasticSystem, refuses_a_matrix_that_is_not_symmetric_on_the_free_dofs) {
  Assembled system = pulled_square(1e30, 0);
  system.A.coeffRef(4, 5) += 1e-3 * system.A.coeff(4, 4);
  EXPECT_EQ(refusal_of(system), "A is not symmetric on the free dofs");
}

TEST(ElasticSystem, refuses_a_negative_diagonal_of_a_free_dof) {
  Assembled turned = pulled_square(1e30, 0.1);
  turned.A *= -1;
  EXPECT_TRUE(
      says(refusal([&] { elastic_system(turned.A, turned.b); }),
           ": no body has a negative stiffness, mind the signs of the varf"));
}

TEST(ElasticSystem, refuses_what_was_assembled_with_different_tgv) {
  const double extent = 4;
  const auto judged = [&](const RowMatrix& A, const VectorXd& b) {
    return refusal([&] { require_same_tgv(elastic_system(A, b), extent); });
  };
  const Assembled penalised = pulled_square(1e30, 0.1),
                  emptied = pulled_square(-1, 0.1);
  EXPECT_EQ(judged(penalised.A, penalised.b), "accepted");
  EXPECT_EQ(judged(emptied.A, emptied.b), "accepted");
  EXPECT_TRUE(says(judged(emptied.A, penalised.b),
                   "assemble A and b with the same tgv"));
  const Assembled still = pulled_square(1e30, 0);
  EXPECT_EQ(judged(still.A, still.b), "accepted");
}

TEST(ElasticSystem, refuses_loads_of_a_dof_that_b_alone_prescribes) {
  Problem problem = body(rectangle(3, 3, 3, 3), material(100, 0.3));
  VectorXd b = problem.b;
  b[0] = 1e27;
  const ElasticSystem system = elastic_system(problem.A, b);
  EXPECT_TRUE(says(refusal([&] { require_same_tgv(system, 4); }),
                   "b is 1e+27 at dof 0, which A does not prescribe"));
}

TEST(ElasticSystem, refuses_sizes_that_do_not_fit) {
  Assembled system = pulled_square(1e30, 0);
  system.b.conservativeResize(31);
  EXPECT_EQ(refusal_of(system), "b has 31 values where 32 are needed");
  EXPECT_EQ(refusal([] { elastic_system(RowMatrix(2, 3), Vector2d::Zero()); }),
            "A has 2 rows and 3 columns, it must be square");
}

}  // namespace
}  // namespace ffcontact
