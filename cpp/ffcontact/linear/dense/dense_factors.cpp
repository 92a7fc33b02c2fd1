// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/dense/dense_factors.hpp"

#include <algorithm>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/linear/dense/blas.hpp"
#include "ffcontact/linear/dense/serial_blas.hpp"

namespace ffcontact {

namespace {

/// Columns of a factor that are computed at once, and of a tile that they update.
constexpr int width_of_cholesky = 256, width_of_lu = 128;
/// Rows below a diagonal block that are solved for at once.
constexpr int rows_of_tile = 512;

template <class Scalar>
Scalar* entry(Scalar* A, int n, int row, int column) {
  return A + row + static_cast<Index>(column) * n;
}

/// The columns of A from first on, by those of L and U at k, whose rows were exchanged.
template <class Scalar>
void update_columns(int n, Scalar* A, const int* pivots, int k, int width,
                    int first, int columns) {
  const int next = k + width, from = k + 1, below = n - next, step = 1;
  const Scalar one = 1, minus = -1;
  Scalar* U = entry(A, n, k, first);
  Blas<Scalar>::laswp(&columns, entry(A, n, 0, first), &n, &from, &next, pivots,
                      &step);
  if (first < k) return;
  Blas<Scalar>::trsm("L", "L", "N", "U", &width, &columns, &one,
                     entry(A, n, k, k), &n, U, &n);
  if (below > 0)
    Blas<Scalar>::gemm("N", "N", &below, &columns, &width, &minus,
                       entry(A, n, next, k), &n, U, &n, &one,
                       entry(A, n, next, first), &n);
}

}  // namespace

template <class Scalar>
void subtract_lower_product(int rows, int columns, int depth, const Scalar* L,
                            int stride_l, Scalar beta, Scalar* C,
                            int stride_c) {
  const Scalar minus = -1;
  const int below = rows - columns;
  Blas<Scalar>::syrk("L", "N", &columns, &depth, &minus, L, &stride_l, &beta, C,
                     &stride_c);
  if (below > 0)
    Blas<Scalar>::gemm("N", "T", &below, &columns, &depth, &minus, L + columns,
                       &stride_l, L, &stride_l, &beta, C + columns, &stride_c);
}

template <class Scalar>
bool factorise_columns(int rows, int columns, Scalar* A, int stride) {
  const SerialBlas serial;
  const Scalar one = 1;
  int info = 0;
  Blas<Scalar>::potrf("L", &columns, A, &stride, &info);
  if (info != 0) return false;
#pragma omp parallel for schedule(dynamic, 1) if (rows - columns > rows_of_tile)
  for (int first = columns; first < rows; first += rows_of_tile) {
    const int count = std::min(rows_of_tile, rows - first);
    Blas<Scalar>::trsm("R", "L", "T", "N", &count, &columns, &one, A, &stride,
                       A + first, &stride);
  }
  return true;
}

template <class Scalar>
bool factorise_cholesky(int n, Scalar* A) {
  const SerialBlas serial;
  for (int k = 0; k < n; k += width_of_cholesky) {
    const int width = std::min(width_of_cholesky, n - k);
    if (!factorise_columns(n - k, width, entry(A, n, k, k), n)) return false;
#pragma omp parallel for schedule(dynamic, 1) if (n - k - width > width)
    for (int first = k + width; first < n; first += width_of_cholesky)
      subtract_lower_product<Scalar>(
          n - first, std::min(width_of_cholesky, n - first), width,
          entry(A, n, first, k), n, 1, entry(A, n, first, first), n);
  }
  return true;
}

template <class Scalar>
void factorise_lu(int n, Scalar* A, int* pivots) {
  const SerialBlas serial;
  for (int k = 0; k < n; k += width_of_lu) {
    const int width = std::min(width_of_lu, n - k), rows = n - k;
    int info = 0;  // a pivot of 0 stays on the diagonal
    Blas<Scalar>::getrf(&rows, &width, entry(A, n, k, k), &n, pivots + k,
                        &info);
    for (int j = k; j < k + width; ++j) pivots[j] += k;
#pragma omp parallel for schedule(dynamic, 1) if (n > width)
    for (int first = 0; first < n; first += width_of_lu)
      if (first != k)
        update_columns(n, A, pivots, k, width, first,
                       std::min(width_of_lu, n - first));
  }
}

#define FFCONTACT_FACTORS(Scalar)                                         \
  template bool factorise_cholesky(int, Scalar*);                         \
  template void factorise_lu(int, Scalar*, int*);                         \
  template bool factorise_columns(int, int, Scalar*, int);                \
  template void subtract_lower_product(int, int, int, const Scalar*, int, \
                                       Scalar, Scalar*, int);
FFCONTACT_FACTORS(double)
FFCONTACT_FACTORS(float)
#undef FFCONTACT_FACTORS

}  // namespace ffcontact
