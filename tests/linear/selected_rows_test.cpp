// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/selected_rows.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact::test {
namespace {

RC_GTEST_PROP(SelectedRows, are_in_the_order_of_their_list, (Random random)) {
  const int rows = *rc::gen::inRange(1, 20), cols = *rc::gen::inRange(1, 20);
  const MatrixXd A = random_matrix(rows, cols, random);
  const auto list =
      *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, rows));
  const SparseMatrix some = selected_rows(A.sparseView(), list);
  RC_ASSERT(some.rows() == static_cast<Index>(list.size()));
  RC_ASSERT(some.cols() == cols);
  RC_ASSERT(MatrixXd(some) == MatrixXd(A(list, Eigen::all)));
}

}  // namespace
}  // namespace ffcontact::test
