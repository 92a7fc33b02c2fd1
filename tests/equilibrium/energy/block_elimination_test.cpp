// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/block_elimination.hpp"

#include <cmath>

#include "ffcontact/equilibrium/energy/tiled_factor.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

/// Blocks in a row, each coupled with the next one, that share an unknown with it: sums of
/// squares of what is in two neighbours.
struct Chain {
  std::vector<Index> first{0};
  MatrixXd A;

  explicit Chain(Random& random) {
    const auto blocks = 2 + static_cast<int>(random() % 4);
    for (int k = 0; k < blocks; ++k)
      first.push_back(first.back() + 3 + static_cast<int>(random() % 5));
    A = MatrixXd::Zero(first.back(), first.back());
    for (int k = 0; k + 1 < blocks; ++k) {
      const Index n = first[k + 2] - first[k];
      MatrixXd B = random_matrix(n, n, random) + 3 * MatrixXd::Identity(n, n);
      // the last unknown of a block is the first one of the next
      B.col(first[k + 1] - first[k]) = B.col(first[k + 1] - first[k] - 1);
      if (k > 0) B.col(0).setZero();
      if (k + 2 < blocks) B.col(n - 1).setZero();
      A.block(first[k], first[k], n, n) += B.transpose() * B;
    }
  }

  int count() const { return static_cast<int>(first.size()) - 1; }
  int size(int k) const { return static_cast<int>(first[k + 1] - first[k]); }
  MatrixXd block(int k, int l) const {
    return A.block(first[k], first[l], size(k), size(l));
  }
};

/// A^-1 b by the factors of the blocks.
VectorXd solved(const Chain& chain, const VectorXd& b) {
  std::vector<std::vector<float>> factor;
  std::vector<int> place{0};
  VectorXd x = VectorXd::Zero(tile_size * chain.A.rows());
  BlockElimination elimination(chain.block(0, 0));
  const auto below = [&](int k) {
    return k + 1 < chain.count() ? chain.size(k + 1) : 0;
  };
  for (int k = 0; k < chain.count(); ++k) {
    if (k + 1 < chain.count())
      elimination.append(chain.block(k + 1, k + 1), chain.block(k + 1, k));
    factor.emplace_back(front_size(chain.size(k), below(k)));
    put_tiles(elimination.eliminated(), factor[k].data());
    x.segment(place[k], chain.size(k)) =
        b.segment(chain.first[k], chain.size(k));
    place.push_back(place[k] + tiled(chain.size(k)));
  }
  for (int k = 0; k < chain.count(); ++k)
    eliminate_tiles(factor[k].data(), chain.size(k), below(k), &x[place[k]]);
  for (int k = chain.count() - 1; k >= 0; --k)
    substitute_tiles(factor[k].data(), chain.size(k), below(k), &x[place[k]]);
  VectorXd result(chain.A.rows());
  for (int k = 0; k < chain.count(); ++k)
    result.segment(chain.first[k], chain.size(k)) =
        x.segment(place[k], chain.size(k));
  return result;
}

RC_GTEST_PROP(BlockElimination, solves_where_blocks_share_unknowns,
              (Random random)) {
  const Chain chain(random);
  const VectorXd b = chain.A * random_vector(chain.A.rows(), random);
  RC_ASSERT((chain.A * solved(chain, b) - b).norm() < 1e-4 * b.norm());
}

}  // namespace
}  // namespace ffcontact
