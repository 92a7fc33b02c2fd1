// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/partial_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ffcontact/elastic/factor/subtrees.hpp"
#include "ffcontact/elastic/stiffness.hpp"
#include "support/random.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Symmetric, with a dominant diagonal and some ten entries a row.
MatrixXd random_matrix(int size, Random& random) {
  MatrixXd A = MatrixXd::Zero(size, size);
  for (int k = 0; k < 5 * size; ++k) {
    const int i = random() % size, j = random() % size;
    A(i, j) = A(j, i) = random_vector(1, random)[0];
  }
  for (int i = 0; i < size; ++i) A(i, i) = 1 + A.row(i).cwiseAbs().sum();
  return A;
}

SparseMatrix lower_triangle(const MatrixXd& A) {
  const MatrixXd lower = A.triangularView<Eigen::Lower>();
  return lower.sparseView();
}

RC_GTEST_PROP(PartialCholesky, is_that_of_the_dense_matrix, (Random random)) {
  const int size = *rc::gen::inRange(1, 90),
            kept = *rc::gen::inRange(0, size + 1), eliminated = size - kept;
  const MatrixXd A = random_matrix(size, random);
  PartialCholesky<double> factor(lower_triangle(A), kept);
  const MatrixXd A_ic = A.topRightCorner(eliminated, kept);
  MatrixXd S = A.bottomRightCorner(kept, kept);
  if (eliminated > 0 && kept > 0)
    S -= A_ic.transpose() *
         A.topLeftCorner(eliminated, eliminated).partialPivLu().solve(A_ic);
  const MatrixXd schur = factor.take_schur();
  RC_ASSERT(schur == schur.transpose());
  const double scale = A.cwiseAbs().maxCoeff();
  if (kept > 0) RC_ASSERT((schur - S).cwiseAbs().maxCoeff() < 1e-13 * scale);
  // A x = b by the factor
  const VectorXd b = random_vector(size, random);
  VectorXd y = factor.half_solve(b);
  if (kept > 0) y.tail(kept) = S.partialPivLu().solve(y.tail(kept)).eval();
  const VectorXd x = factor.other_half_solve(y);
  RC_ASSERT((A * x - b).cwiseAbs().maxCoeff() < 1e-12);
}

/// At any scale of the right-hand side, beside the factor in double precision.
RC_GTEST_PROP(PartialCholesky, in_single_precision_is_near, (Random random)) {
  const int size = *rc::gen::inRange(2, 90), kept = *rc::gen::inRange(1, size);
  const MatrixXd A = random_matrix(size, random);
  PartialCholesky<double> exact(lower_triangle(A), kept);
  PartialCholesky<float> factor(lower_triangle(A), kept);
  const MatrixXd S = exact.take_schur();
  const Eigen::MatrixXf rough = factor.take_schur();
  RC_ASSERT(rough == rough.transpose());
  RC_ASSERT((rough.cast<double>() - S).cwiseAbs().maxCoeff() <=
            1e-5 * S.cwiseAbs().maxCoeff());
  const double scale = std::pow(10, *rc::gen::inRange(-120, 120));
  const VectorXd b = scale * random_vector(size, random),
                 y = exact.half_solve(b), x = exact.other_half_solve(y);
  RC_ASSERT((factor.half_solve(b) - y).norm() <= 1e-5 * y.norm());
  RC_ASSERT((factor.other_half_solve(y) - x).norm() <= 1e-5 * x.norm());
}

TEST(PartialCholesky, tells_matrices_that_are_not_positive_definite) {
  Random random(3);
  MatrixXd A = random_matrix(40, random);
  EXPECT_GT(
      PartialCholesky<double>(lower_triangle(A), 5).reciprocal_condition(),
      1e-3);
  A(20, 20) = -1;
  EXPECT_EQ(
      PartialCholesky<double>(lower_triangle(A), 5).reciprocal_condition(), 0);
  // what stays may be anything
  EXPECT_GT(
      PartialCholesky<double>(lower_triangle(A), 20).reciprocal_condition(),
      1e-3);
}

/// The stiffness of a brick of four layers of vertices that nothing holds. Eliminated
/// after both of its neighbours, the third layer is dense.
MatrixXd layered_stiffness(const SolidMesh& mesh, std::vector<int>& dofs) {
  const RowMatrix K =
      stiffness(mesh, HookeTensors<3>(mesh.cell_count(), isotropic<3>(60, 40)));
  const int layer = static_cast<int>(K.rows()) / 4;
  for (int k : {3, 1, 2, 0})
    for (int dof = k * layer; dof < (k + 1) * layer; ++dof) dofs.push_back(dof);
  return MatrixXd(K)(dofs, dofs);
}

TEST(PartialCholesky, of_a_brick_has_blocks_of_several_panels) {
  const SolidMesh mesh = brick({9, 9, 3}, {3, 3, 1});
  std::vector<int> dofs;
  const MatrixXd K = layered_stiffness(mesh, dofs);
  constexpr int kept = 300;
  const SparseMatrix lower = lower_triangle(K);
  const Supernodes nodes = supernodes(lower, 900);
  int widest = 0;
  for (int s = 0; s < nodes.count(); ++s)
    widest = std::max(widest, nodes.column_count(s));
  EXPECT_EQ(widest, widest_supernode);
  PartialCholesky<double> factor(lower, kept);
  const MatrixXd S = factor.take_schur();
  // translations do no work
  for (int c = 0; c < 3; ++c) {
    VectorXd motion(kept);
    for (int k = 0; k < kept; ++k) motion[k] = dofs[900 + k] % 3 == c;
    EXPECT_LT((S * motion).cwiseAbs().maxCoeff(),
              1e-11 * S.cwiseAbs().maxCoeff());
  }
  const VectorXd u = VectorXd::LinSpaced(1200, -1, 1).array().cube();
  VectorXd y = factor.half_solve(K * u);
  EXPECT_LT((y.tail(kept) - S * u.tail(kept)).norm(), 1e-11 * y.norm());
  y.tail(kept) = u.tail(kept);
  EXPECT_LT((factor.other_half_solve(y) - u).norm(), 1e-10 * u.norm());
}

TEST(Subtrees, do_not_depend_on_each_other) {
  std::vector<int> dofs;
  Random random(7);
  const MatrixXd A = random_matrix(400, random);
  const Supernodes nodes = supernodes(lower_triangle(A), 380);
  const Subtrees tree = subtrees(nodes, 0.1);
  std::vector<int> owner(380, -2);  // of each column; -1 above the subtrees
  const auto claim = [&](int s, int by) {
    for (int j = nodes.first_column[s]; j < nodes.first_column[s + 1]; ++j) {
      EXPECT_EQ(owner[j], -2);
      owner[j] = by;
    }
  };
  for (int s : tree.above) claim(s, -1);
  for (std::size_t k = 0; k < tree.supernodes.size(); ++k)
    for (int s : tree.supernodes[k]) claim(s, static_cast<int>(k));
  EXPECT_EQ(std::count(owner.begin(), owner.end(), -2), 0);
  EXPECT_GT(tree.supernodes.size(), 4u);
  EXPECT_FALSE(tree.above.empty());
  for (int s = 0; s < nodes.count(); ++s)
    for (const int* row = nodes.rows_below(s); row != nodes.end_of_rows(s);
         ++row)
      if (*row < 380) {
        const int own = owner[nodes.first_column[s]];
        EXPECT_TRUE(owner[*row] == own || owner[*row] == -1);
      }
}

}  // namespace
}  // namespace ffcontact
