// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/row_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(RowMatrix, is_made_of_entries_in_any_order, (Random random)) {
  const int rows = *rc::gen::inRange(1, 20), columns = *rc::gen::inRange(1, 20);
  MatrixXd dense = random_matrix(rows, columns, random);
  std::vector<int> place;
  for (int k = 0; k < dense.size(); ++k)
    if (random() % 3 == 0)
      place.push_back(k);
    else
      dense(k % rows, k / rows) = 0;
  std::shuffle(place.begin(), place.end(), random);
  std::vector<int> row, column;
  std::vector<double> value;
  for (int k : place) {
    row.push_back(k % rows);
    column.push_back(k / rows);
    value.push_back(dense(row.back(), column.back()));
  }
  const RowMatrix A =
      matrix_of_entries(rows, columns, static_cast<Index>(place.size()),
                        row.data(), column.data(), value.data());
  RC_ASSERT(A.isCompressed());
  RC_ASSERT(A.nonZeros() == static_cast<Index>(place.size()));
  RC_ASSERT(MatrixXd(A) == dense);
  for (int i = 0; i < rows; ++i)
    RC_ASSERT(std::is_sorted(A.innerIndexPtr() + A.outerIndexPtr()[i],
                             A.innerIndexPtr() + A.outerIndexPtr()[i + 1]));
}

TEST(MovableMatrix, hands_over_its_entries) {
  RowMatrix A(2, 2);
  A.coeffRef(1, 0) = 3;
  A.makeCompressed();
  const double* const entries = A.valuePtr();
  MovableMatrix moved(std::move(A)), again(std::move(moved)), assigned;
  assigned = std::move(again);
  EXPECT_EQ(assigned.valuePtr(), entries);
  EXPECT_EQ(assigned.coeff(1, 0), 3);
  const MovableMatrix copy(assigned);
  EXPECT_NE(copy.valuePtr(), entries);
  EXPECT_EQ(copy.coeff(1, 0), 3);
}

}  // namespace
}  // namespace ffcontact
