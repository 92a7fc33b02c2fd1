// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/products.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace ffcontact::test {
namespace {

/// Largest distance of M from the sums of a(i, k) b(k, j).
template <class A, class B>
double distance(const MatrixXd& M, int depth, const A& a, const B& b) {
  double off = 0;
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j < M.cols(); ++j) {
      double sum = 0;
      for (int k = 0; k < depth; ++k) sum += a(i, k) * b(k, j);
      off = std::max(off, std::abs(M(i, j) - sum));
    }
  return off;
}

RC_GTEST_PROP(Products, are_the_sums_of_their_definition, (Random random)) {
  const int m = *rc::gen::inRange(0, 40), n = *rc::gen::inRange(0, 40),
            depth = *rc::gen::inRange(0, 40);
  const MatrixXd A = random_matrix(m, depth, random), At = A.transpose(),
                 B = random_matrix(depth, n, random),
                 M = random_matrix(m, m, random);
  const double rounding = 1e-12;  // 2 depth^2 epsilon bounds that of both sums
  const MatrixXd AB = product(A, B), same = transposed_product(At, B);
  RC_ASSERT(AB.rows() == m && AB.cols() == n);
  RC_ASSERT(same.rows() == m && same.cols() == n);
  RC_ASSERT(distance(AB, depth, A, B) < rounding);
  RC_ASSERT(distance(same, depth, A, B) < rounding);
  MatrixXd sum = M;
  add_square(A, sum);
  RC_ASSERT(distance(sum - M, depth, A, At) < rounding);
}

}  // namespace
}  // namespace ffcontact::test
