// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/tiled_factor.hpp"

#include "ffcontact/linear/dense/cholesky.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

RC_GTEST_PROP(TiledFactor, solves_in_single_precision, (Random random)) {
  const auto n = 1 + static_cast<int>(random() % 40);
  const MatrixXd B = random_matrix(n, n, random),
                 A = B * B.transpose() + n * MatrixXd::Identity(n, n);
  const VectorXd b = random_vector(n, random);
  const Cholesky cholesky(A);
  std::vector<float> factor(factor_size(n));
  VectorXd x = VectorXd::Zero(tiled(n));
  put_tiles(cholesky.lower(), factor.data());
  x.head(n) = b;
  eliminate_tiles(factor.data(), n, 0, x.data());
  substitute_tiles(factor.data(), n, 0, x.data());
  const VectorXd found = x.head(n);
  RC_ASSERT((found - cholesky.solve(b)).norm() < 1e-6);
  for (int i = n; i < tiled(n); ++i) RC_ASSERT(x[i] == 0);
}

}  // namespace
}  // namespace ffcontact
