// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/prescribed_dofs.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/refusals.hpp"

namespace ffcontact {
namespace {

using namespace test;

RowMatrix rows_of(const MatrixXd& A) { return A.sparseView(); }

/// A chain of springs of these dofs, 1 to 9, with its ends free.
MatrixXd chain(int n) {
  MatrixXd A = MatrixXd::Zero(n, n);
  for (int k = 0; k + 1 < n; ++k)
    A.block<2, 2>(k, k) +=
        (k % 9 + 1) * (Matrix2d() << 1, -1, -1, 1).finished();
  return A;
}

/// As FreeFEM prescribes with tgv=1e30, -1 and -2.
enum class Way { penalty, row, row_and_column };

MatrixXd prescribed(MatrixXd A, const Flags& dofs, Way way) {
  for (Index k = 0; k < A.rows(); ++k) {
    if (!dofs[k]) continue;
    if (way == Way::penalty) {
      A(k, k) = 1e30;
      continue;
    }
    A.row(k).setZero();
    if (way == Way::row_and_column) A.col(k).setZero();
    A(k, k) = 1;
  }
  return A;
}

RC_GTEST_PROP(PrescribedDofs, are_found_however_they_are_prescribed,
              (Random random)) {
  const int n = 4 * *rc::gen::inRange(1, 8) + 2;
  const Way way =
      *rc::gen::element(Way::penalty, Way::row, Way::row_and_column);
  Flags dofs(n);
  for (int k = 0; k < n; ++k)  // each free dof has a free neighbour
    dofs[k] = k % 4 < 2 ? 0 : random() % 2;
  const RowMatrix A = rows_of(prescribed(chain(n), dofs, way));
  RC_ASSERT(prescribed_dofs(A) == dofs);
  bool any = false;
  for (const char one : dofs) any = any || one;
  RC_ASSERT(has_columns(A, dofs) == (any && way != Way::row_and_column));
}

/// tgv = -2: dof 2 has nothing but its stiffness, 20 + 30, and dof 0 its 10.
TEST(PrescribedDofs, are_not_free_ones_between_them) {
  const Flags dofs{0, 1, 0, 1, 0, 0};
  const MatrixXd A = prescribed(10 * chain(6), dofs, Way::row_and_column);
  EXPECT_EQ(prescribed_dofs(rows_of(A)), dofs);
  EXPECT_TRUE(says(refusal([&] { prescribed_dofs(rows_of(7 * A)); }),
                   "dof 0 has nothing but its diagonal 70"));
}

TEST(PrescribedDofs, have_one_value_in_a_scaled_matrix) {
  const Flags dofs{0, 0, 1, 0, 0, 1};
  const MatrixXd A = prescribed(chain(6), dofs, Way::row_and_column);
  EXPECT_EQ(prescribed_dofs(rows_of(7 * A)), dofs);
}

/// tgv = -1, each row in a unit of its own.
TEST(PrescribedDofs, have_any_value_where_their_columns_couple) {
  const Flags dofs{0, 1, 0, 0, 1, 0};
  MatrixXd A = prescribed(chain(6), dofs, Way::row);
  A.row(1) *= 7;
  A.row(4) *= 3;
  EXPECT_EQ(prescribed_dofs(rows_of(A)), dofs);
}

/// A row of zeros prescribes nothing; a penalty of 1e12 times the row is none.
TEST(PrescribedDofs, are_penalised_by_more_than_1e12) {
  MatrixXd A = chain(4);
  A(1, 1) = 0.999e12 * 3;
  EXPECT_EQ(prescribed_dofs(rows_of(A)), Flags({0, 0, 0, 0}));
  A(1, 1) = 1.001e12 * 3;
  EXPECT_EQ(prescribed_dofs(rows_of(A)), Flags({0, 1, 0, 0}));
  A.row(1).setZero();
  A.col(1).setZero();
  A(0, 0) = 1;
  EXPECT_EQ(prescribed_dofs(rows_of(A)), Flags({1, 0, 0, 0}));
}

}  // namespace
}  // namespace ffcontact
