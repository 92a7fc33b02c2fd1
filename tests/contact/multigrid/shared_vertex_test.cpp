// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/multigrid/shared_vertex.hpp"

#include <gtest/gtest.h>

#include "ffcontact/linear/norms.hpp"
#include "support/solid_corners.hpp"
#include "support/turning.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// On edges and in corners, along planes of symmetry and between moved supports.
std::vector<SolidProblem> problems_with_shared_vertices() {
  Random random(1);
  std::vector<SolidProblem> problems{
      block_in_a_corner(brick({3, 2, 2}, {3, 2, 2}), 1, 0),
      block_in_a_corner(brick({3, 2, 2}, {3, 2, 2}), 2, 0),
      SolidCorner(1, 0, random).problem, SolidCorner(2, 0, random).problem,
      brick_with_a_moved_side(0, 1).problem};
  for (std::size_t k = 0; k < 2; ++k) {
    problems.push_back(problems[k]);
    problems.back().surface =
        turned_at_random(problems[k].surface, 0.3, random);
  }
  return problems;
}

TEST(SharedVertex, moves_its_rows_and_has_its_displacement) {
  Random random(2);
  for (const SolidProblem& problem : problems_with_shared_vertices()) {
    const ProblemUnknowns of{problem};
    ASSERT_FALSE(of.unknowns.shared.empty());
    const VectorXd u =
        on_free_dofs(of.system, random_vector(of.system.dof_count(), random));
    const VectorXd v =
        VectorXd(contact_components(problem.surface, u).reshaped());
    for (const SharedVertex& shared : of.unknowns.shared) {
      VectorXd y = u;
      auto own = y.segment<3>(3 * shared.vertex);
      own.setZero();
      own.head(shared.own) = VectorXd(v(shared.rows)).head(shared.own);
      EXPECT_LE(max_norm(shared.motion(y) - v(shared.rows)), 1e-12);
      Vector3d moved = own;
      for (std::size_t j = 0; j < shared.faced.size(); ++j)
        moved += shared.B[j] * u.segment<3>(3 * shared.faced[j].vertex);
      EXPECT_LE(max_norm(shared.T * moved - u.segment<3>(3 * shared.vertex)),
                1e-12);
    }
  }
}

/// E'P and E_j'P are what nodal forces do on y.
TEST(SharedVertex, hands_on_the_forces_of_its_rows) {
  Random random(3);
  for (const SolidProblem& problem : problems_with_shared_vertices()) {
    const ProblemUnknowns of{problem};
    VectorXd P = random_vector(3 * problem.surface.node_count(), random);
    for (Index row = 0; row < P.size(); ++row)
      if (of.trace.held[row]) P[row] = 0;
    const Matrix3Xd force = P.reshaped(3, problem.surface.node_count());
    VectorXd F = of.unknowns.frames.components(
        nodal_load(problem.surface, force, of.system.dof_count()));
    of.unknowns.for_rows([&](int row, int k) { F[k] -= P[row]; });
    for (const SharedVertex& shared : of.unknowns.shared) {
      const VectorXd own = P(shared.rows);
      F.segment<3>(3 * shared.vertex) -= shared.E.transpose() * own;
      for (const SharedVertex::Link& link : shared.faced)
        F.segment<3>(3 * link.vertex) -= link.E.transpose() * own;
    }
    EXPECT_LE(max_norm(on_free_dofs(of.system, F)), 1e-12);
  }
}

/// Of bodies as stiff as 1 at each dof a spring along v is so much beside E'E.
TEST(SharedVertex, knows_what_is_stiff_beside_the_bodies) {
  for (const SolidProblem& problem : problems_with_shared_vertices()) {
    ProblemUnknowns of{problem};
    of.system.stiffness.setIdentity();
    for (const SharedVertex& shared :
         shared_vertices(problem.surface, of.trace,
                         VectorXd::Zero(of.trace.held.size()), of.system)) {
      VectorXd square = shared.E.rowwise().squaredNorm();
      for (const SharedVertex::Link& link : shared.faced)
        square += link.E.rowwise().squaredNorm();
      const VectorXd beside = shared.stiffness.cwiseProduct(square);
      EXPECT_LE(max_norm(beside - VectorXd::Ones(beside.size())), 1e-12);
    }
  }
}

/// The rows of the sheets' normals are its own, and the last ones couple.
TEST(SharedVertex, orders_its_rows) {
  Random random(4);
  const SolidCorner corner(2, 0, random);
  for (const SharedVertex& shared :
       ProblemUnknowns{corner.problem}.unknowns.shared) {
    int normals = 0;
    for (int k = 0; k < shared.own; ++k) normals += shared.rows[k] % 3 == 0;
    EXPECT_EQ(normals, shared.row_count() / 3);
    for (int k = 0; k < shared.row_count(); ++k) {
      bool couples = false;
      for (const SharedVertex::Link& link : shared.faced)
        couples = couples || !link.E.row(k).isZero(0);
      EXPECT_EQ(couples, k >= shared.row_count() - shared.coupling);
    }
  }
}

/// Rounding couples nothing.
TEST(SharedVertex, does_not_couple_a_vertex_with_itself) {
  Random random(1);
  SolidProblem problem = SolidCorner::of_matching_meshes(0).problem;
  problem.surface = turned_at_random(problem.surface, 0.3, random);
  const ProblemUnknowns of{problem};
  EXPECT_FALSE(of.unknowns.shared.empty());
  for (const SharedVertex& shared : of.unknowns.shared)
    EXPECT_EQ(shared.coupling, 0);
}

}  // namespace
}  // namespace ffcontact
