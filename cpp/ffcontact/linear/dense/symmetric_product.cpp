// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/symmetric_product.hpp"

#include <algorithm>

#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

namespace {

/// Panels k, k + parts, .. are a part: all of nearly the same size.
constexpr int parts = 16;
/// Of a tile that is read twice while it is near.
constexpr Index width = 16, height = 2048;

/// y += A x or A' x for a tile of S.
void add_product(const char* transpose, const Ref<const MatrixXd>& tile,
                 const double* x, double* y) {
  const auto rows = static_cast<int>(tile.rows()),
             columns = static_cast<int>(tile.cols()),
             stride = static_cast<int>(tile.outerStride());
  const int next = 1;
  const double factor = 1;
  Blas<double>::gemv(transpose, &rows, &columns, &factor, tile.data(), &stride,
                     x, &next, &factor, y, &next);
}

/// sum += the columns of a panel times x, and their mirror images.
void add_panel(const MatrixXd& S, const VectorXd& x, Index first, double* sum) {
  const Index n = S.rows(), columns = std::min(width, n - first);
  Map<VectorXd>(sum + first, columns) +=
      S.block(first, first, columns, columns).selfadjointView<Eigen::Lower>() *
      x.segment(first, columns);
  for (Index row = first + columns; row < n; row += height) {
    const auto tile = S.block(row, first, std::min(height, n - row), columns);
    add_product("N", tile, x.data() + first, sum + row);
    add_product("T", tile, x.data() + row, sum + first);
  }
}

}  // namespace

VectorXd symmetric_product(const MatrixXd& S, const VectorXd& x) {
  const SerialBlas serial;
  const Index n = S.rows();
  MatrixXd sums = MatrixXd::Zero(n, parts);
#pragma omp parallel for schedule(dynamic, 1)
  for (int part = 0; part < parts; ++part)
    for (Index first = part * width; first < n; first += parts * width)
      add_panel(S, x, first, sums.col(part).data());
  return sums.rowwise().sum();
}

}  // namespace ffcontact
