// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/condensed_stiffness.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <set>
#include <stdexcept>

#include "ffcontact/elastic/factor/scaled_stiffness.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/free_displacement.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// A loaded body, fixed at its top or not at all.
ElasticSystem random_system(bool fixed, Random& random, Mesh& mesh) {
  mesh = irregular(4, 3, 4, 3, random);
  Problem problem = body(mesh, material(100, 0.3));
  problem.b = random_vector(problem.b.size(), random);
  if (fixed)
    clamp(problem, top,
          [](const Vector2d& x) { return Vector2d(0.01 * x.x(), -0.02); });
  return problem.system();
}

/// Both dofs of two vertices, which hold a floating body, and one dof of `more` others,
/// in random order.
std::vector<int> random_kept(const ElasticSystem& system, int more,
                             Random& random) {
  std::vector<int> dofs = free_dofs(system), kept;
  shuffle(dofs, random);
  std::set<int> vertices;
  for (int dof : dofs) {
    if (static_cast<int>(vertices.size()) == 2 + more) break;
    if (!vertices.insert(dof / 2).second) continue;
    kept.push_back(dof);
    if (vertices.size() <= 2) kept.push_back(dof ^ 1);
  }
  return kept;
}

/// S and g by dense elimination of the free dofs that are not kept.
struct Dense {
  MatrixXd S;
  VectorXd g;
};
Dense dense_condensation(const ElasticSystem& system,
                         const std::vector<int>& kept) {
  std::vector<int> inner = free_dofs(system);
  inner.erase(std::remove_if(inner.begin(), inner.end(),
                             [&](int dof) {
                               return std::find(kept.begin(), kept.end(),
                                                dof) != kept.end();
                             }),
              inner.end());
  const MatrixXd K(system.stiffness), K_ic = K(inner, kept);
  const Eigen::LLT<MatrixXd> K_ii(K(inner, inner));
  return {
      K(kept, kept) - K_ic.transpose() * K_ii.solve(K_ic),
      system.load(kept) - K_ic.transpose() * K_ii.solve(system.load(inner))};
}

RC_GTEST_PROP(CondensedStiffness, is_the_dense_schur_complement,
              (Random random)) {
  Mesh mesh;
  const ElasticSystem system =
      random_system(*rc::gen::arbitrary<bool>(), random, mesh);
  const std::vector<int> kept =
      random_kept(system, *rc::gen::inRange(0, 8), random);
  const CondensedStiffness stiffness(system, kept);
  const Dense dense = dense_condensation(system, kept);
  RC_ASSERT(relative_difference(stiffness.schur(), dense.S) < 1e-11);
  RC_ASSERT(relative_difference(stiffness.condensed(system.load).on_kept,
                                dense.g) < 1e-11);
}

RC_GTEST_PROP(CondensedStiffness,
              extended_displacement_balances_the_load_on_the_other_dofs,
              (Random random)) {
  Mesh mesh;
  const ElasticSystem system =
      random_system(*rc::gen::arbitrary<bool>(), random, mesh);
  const std::vector<int> kept =
      random_kept(system, *rc::gen::inRange(0, 8), random);
  const VectorXd u_c = random_vector(static_cast<Index>(kept.size()), random);
  const CondensedStiffness stiffness(system, kept);
  const VectorXd u = stiffness.extended(stiffness.condensed(system.load), u_c);
  const VectorXd residual = system.stiffness * u - system.load;
  const double scale = 1e-11 * 100 * u.cwiseAbs().maxCoeff();
  for (int dof : free_dofs(system)) {
    const auto place = std::find(kept.begin(), kept.end(), dof);
    if (place == kept.end()) RC_ASSERT(std::abs(residual[dof]) < scale);
    if (place != kept.end())
      RC_ASSERT(std::abs(u[dof] - u_c[place - kept.begin()]) <
                1e-12 * u_c.cwiseAbs().maxCoeff());
  }
  // On the kept dofs the residual is S u_c - g.
  const VectorXd expected =
      stiffness.schur() * u_c - stiffness.condensed(system.load).on_kept;
  RC_ASSERT((VectorXd(residual(kept)) - expected).cwiseAbs().maxCoeff() <
            scale);
}

TEST(CondensedStiffness, of_a_floating_body_keeps_exactly_the_rigid_motions) {
  Random random(5);
  Mesh mesh;
  const ElasticSystem system = random_system(false, random, mesh);
  const std::vector<int> kept = random_kept(system, 6, random);
  const MatrixXd S = CondensedStiffness(system, kept).schur();
  const MatrixXd motions =
      free_rigid_motions(mesh, system.prescribed)(kept, Eigen::all);
  EXPECT_LT((S * motions).cwiseAbs().maxCoeff(),
            1e-11 * S.cwiseAbs().maxCoeff());
  EXPECT_EQ(Eigen::FullPivLU<MatrixXd>(S).setThreshold(1e-10).rank(), 7);
}

TEST(CondensedStiffness, without_kept_dofs_solves_the_system) {
  Random random(6);
  Mesh mesh;
  const ElasticSystem system = random_system(true, random, mesh);
  const VectorXd u = displacement(system) - system.prescribed_value;
  const std::vector<int> dofs = free_dofs(system);
  EXPECT_LT(VectorXd((system.stiffness * u - system.load)(dofs)).norm(),
            1e-12 * system.load.norm());
}

TEST(CondensedStiffness, keeps_all_free_dofs_when_asked_to) {
  Problem problem = body(rectangle(2, 1, 2, 1), material(100, 0.3));
  clamp(problem, top);
  const ElasticSystem system = problem.system();
  const std::vector<int> kept = free_dofs(system);
  EXPECT_LT(relative_difference(CondensedStiffness(system, kept).schur(),
                                MatrixXd(problem.A)(kept, kept)),
            1e-13);
}

TEST(CondensedStiffness,
     refuses_kept_dofs_that_are_prescribed_repeated_or_out_of_range) {
  const ElasticSystem system = example_1(Multiplier::force, 2).system();
  const int prescribed = system.dof_count() - 1;
  const auto refusal_of = [&](const std::vector<int>& kept) {
    return refusal([&] { CondensedStiffness(system, kept); });
  };
  EXPECT_EQ(refusal_of({0, prescribed}),
            "kept dof 29 is prescribed or does not exist");
  EXPECT_EQ(refusal_of({-1}), "kept dof -1 is prescribed or does not exist");
  EXPECT_EQ(refusal_of({30}), "kept dof 30 is prescribed or does not exist");
  EXPECT_EQ(refusal_of({4, 2, 4}), "kept dof 4 is listed twice");
}

TEST(CondensedStiffness, refuses_more_kept_dofs_than_memory_has_room_for) {
  EXPECT_EQ(refusal([] { require_room_for_schur(20000, 16e9); }),
            "20000 free dofs where bodies may touch need dense matrices of 9.6 "
            "GB, more than half of the memory (16 GB): state contact on a "
            "smaller part of the boundary, or on a coarser mesh");
  require_room_for_schur(18000, 16e9);
}

TEST(CondensedStiffness, fails_when_a_part_of_the_body_is_held_by_nothing) {
  Problem problem = body(joined(rectangle(2, 2, 2, 2), rectangle(2, 2, 2, 2)),
                         material(100, 0.3));
  clamp(problem, top);
  const ElasticSystem system = problem.system();
  EXPECT_THROW(CondensedStiffness(system, {0, 1}), std::runtime_error);
  EXPECT_THROW(CondensedStiffness(
                   body(rectangle(2, 2, 2, 2), material(1, 0)).system(), {}),
               std::runtime_error);
}

TEST(CondensedStiffness, refuses_loads_and_displacements_of_another_size) {
  const ElasticSystem system = example_1(Multiplier::force, 2).system();
  const CondensedStiffness stiffness(system, {0, 1});
  EXPECT_EQ(refusal([&] { stiffness.condensed(Vector2d::Zero()); }),
            "load has 2 values where 30 are needed");
  EXPECT_EQ(refusal([&] {
              stiffness.extended(stiffness.condensed(system.load),
                                 Vector3d::Zero());
            }),
            "kept displacement has 3 values where 2 are needed");
}

/// A square held on its left side, with other constants for every body.
ElasticSystem held_square(int cells, double modulus) {
  Problem problem = body(rectangle(cells, cells, 1, 1), material(modulus, 0.3));
  add_traction(problem, right, {1, -2});
  clamp(problem, left);
  return problem.system();
}

TEST(CondensedStiffness, of_separate_bodies_is_that_of_each) {
  const std::vector<ElasticSystem> bodies{
      held_square(6, 100), held_square(4, 3), held_square(5, 20)};
  const ElasticSystem joined = joined_systems(bodies);
  std::vector<int> kept;
  for (int place = 0; place < 3; ++place)  // in turn one dof of each body
    for (int k = 0, first = 0; k < 3; first += bodies[k++].dof_count())
      kept.push_back(first + free_dofs(bodies[k])[7 * place + 2]);
  const CondensedStiffness condensed(joined, kept);
  const Dense dense = dense_condensation(joined, kept);
  EXPECT_LT(relative_difference(condensed.schur(), dense.S), 1e-11);
  EXPECT_LT(
      relative_difference(condensed.condensed(joined.load).on_kept, dense.g),
      1e-11);
  const VectorXd u_c = VectorXd::LinSpaced(9, 0.1, 0.9),
                 u = condensed.extended(condensed.condensed(joined.load), u_c);
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(u[kept[k]], u_c[k], 1e-12);
}

TEST(CondensedStiffness, with_all_dofs_kept_is_the_stiffness_in_their_order) {
  const ElasticSystem system = held_square(4, 100);
  const std::vector<int> kept = free_dofs(system);
  const CondensedStiffness condensed(system, kept);
  const Dense dense = dense_condensation(system, kept);
  EXPECT_LT(relative_difference(condensed.schur(), dense.S), 1e-13);
  EXPECT_LT(
      relative_difference(condensed.condensed(system.load).on_kept, dense.g),
      1e-13);
  const VectorXd u_c = VectorXd::LinSpaced(dense.g.size(), 0.1, 0.9);
  const VectorXd u = condensed.extended(condensed.condensed(system.load), u_c);
  for (std::size_t k = 0; k < kept.size(); ++k)
    EXPECT_NEAR(u[kept[k]], u_c[static_cast<int>(k)], 1e-12);
}

TEST(CondensedStiffness, keeps_more_dofs_than_one_block_of_its_product) {
  const ElasticSystem system = held_square(14, 100);
  std::vector<int> kept = free_dofs(system);
  kept.resize(300);
  EXPECT_LT(relative_difference(CondensedStiffness(system, kept).schur(),
                                dense_condensation(system, kept).S),
            1e-10);
}

}  // namespace
}  // namespace ffcontact
