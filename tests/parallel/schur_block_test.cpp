// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/parallel/schur_block.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "ffcontact/elastic/factor/schur_products.hpp"
#include "support/random.hpp"
#include "support/threads.hpp"

namespace ffcontact {
namespace {

using namespace test;

MatrixXd symmetric_matrix(int size, Random& random) {
  const MatrixXd M =
      random_vector(Index{size} * size, random).reshaped(size, size);
  return M + M.transpose();
}

/// S dealt to a grid of processes.
std::vector<SchurBlock> dealt(const MatrixXd& S, int length, int rows,
                              int columns, bool single) {
  const auto size = static_cast<int>(S.rows());
  std::vector<SchurBlock> blocks;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      SchurBlock block{dealt_numbers(size, length, i, rows),
                       dealt_numbers(size, length, j, columns),
                       {}};
      const MatrixXd values = S(block.row, block.column);
      if (single)
        block.values = MatrixXf(values.cast<float>());
      else
        block.values = values;
      blocks.push_back(std::move(block));
    }
  return blocks;
}

SparseMatrix random_sparse(int rows, int columns, Random& random) {
  Triplets entries;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < 2; ++k)
      entries.emplace_back(i, random() % columns, *real(-1, 1));
  return packed(rows, columns, entries);
}

/// Whatever the grid, also one with more processes than runs of numbers.
RC_GTEST_PROP(SchurBlock, parts_add_up, (Random random)) {
  const int size = *rc::gen::inRange(1, 40), length = *rc::gen::inRange(1, 9);
  const bool single = *rc::gen::arbitrary<bool>();
  const MatrixXd given = symmetric_matrix(size, random),
                 S = single ? MatrixXd(given.cast<float>().cast<double>())
                            : given;
  const std::vector<SchurBlock> blocks = dealt(
      S, length, *rc::gen::inRange(1, 4), *rc::gen::inRange(1, 4), single);
  const VectorXd x = random_vector(size, random);
  const SparseMatrix R = random_sparse(size, 1 + size / 3, random);
  std::vector<int> group(size);
  for (int& of : group) of = static_cast<int>(random() % (1 + size / 3));
  VectorXd y = VectorXd::Zero(size);
  MatrixXd coarse = MatrixXd::Zero(R.cols(), R.cols());
  Triplets entries;
  for (const SchurBlock& block : blocks) {
    y(block.row) += product_part(block, x);
    coarse += congruent_part(block, R);
    const Triplets own = diagonal_part(block, group);
    entries.insert(entries.end(), own.begin(), own.end());
  }
  const WholeSchur whole(S);
  const double rounding = 1e-13 * size;
  RC_ASSERT((y - S * x).lpNorm<Eigen::Infinity>() <= rounding);
  RC_ASSERT((y - whole.product(x)).lpNorm<Eigen::Infinity>() <= rounding);
  RC_ASSERT((coarse - R.transpose() * S * R).norm() <= size * rounding);
  RC_ASSERT((coarse - whole.congruent(R)).norm() <= size * rounding);
  MatrixXd blocks_of_S = S;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      if (group[i] != group[j]) blocks_of_S(i, j) = 0;
  RC_ASSERT(MatrixXd(packed(size, size, entries)) == blocks_of_S);
  RC_ASSERT(MatrixXd(whole.diagonal_blocks(group)) == blocks_of_S);
  RC_ASSERT(whole.diagonal() == S.diagonal());
}

TEST(SchurBlock, products_do_not_depend_on_threads) {
  Random random(3);
  SchurBlock block{std::vector<int>(700), std::vector<int>(700), {}};
  std::iota(block.row.begin(), block.row.end(), 0);
  block.column = block.row;
  block.values = MatrixXf(symmetric_matrix(700, random).cast<float>());
  const VectorXd x = random_vector(700, random);
  const auto product = [&] { return product_part(block, x); };
  EXPECT_EQ(on_threads(2, product), on_threads(1, product));
}

}  // namespace
}  // namespace ffcontact
