// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/multigrid/block_rows.hpp"

namespace ffcontact {

template <int height, int width>
VectorXf product(const BlockRows<height, width>& A, const VectorXf& x) {
  VectorXf y(static_cast<Index>(height) * A.rows());
#pragma omp parallel for
  for (int i = 0; i < A.rows(); ++i) block_of<height>(y, i) = A.row_times(i, x);
  return y;
}

template VectorXf product(const BlockRows<3, 3>&, const VectorXf&);
template VectorXf product(const BlockRows<3, 6>&, const VectorXf&);
template VectorXf product(const BlockRows<6, 6>&, const VectorXf&);

}  // namespace ffcontact
