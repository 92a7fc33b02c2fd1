// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The Cholesky factor L of a small matrix A = L L' stored in single precision, in tiles
/// of 4 x 4 that processors multiply at once: for an A that only steers. What it solves
/// for is of double precision, so that last digits of x do not become those of a float.
/// The tiles of the lower triangle stand column by column, those on the diagonal inverted;
/// unknowns that are missing in the last ones count as 1.

constexpr int tile_size = 4, numbers_in_tile = tile_size * tile_size;

/// Numbers that hold n unknowns in whole tiles.
constexpr int tiled(int n) {
  return (n + tile_size - 1) / tile_size * tile_size;
}

/// Numbers in the columns of n unknowns, with rows of `below` more.
constexpr Index front_size(int n, int below) {
  const Index own = tiled(n) / tile_size, all = own + tiled(below) / tile_size;
  return numbers_in_tile * (all * (all + 1) - (all - own) * (all - own + 1)) /
         2;
}
/// Numbers in the factor of n unknowns.
constexpr Index factor_size(int n) { return front_size(n, 0); }

/// A tile as it is multiplied.
template <class Scalar>
Matrix4d tile_at(const Scalar* numbers) {
  return Map<const Matrix<Scalar, tile_size, tile_size>>(numbers)
      .template cast<double>();
}

/// n columns of L in tiles; the rows below the n-th begin a new tile.
/// @param L       the lower triangle and the rows below it [.. x n]; an infinite pivot, with
///                0 below it, makes its unknown 0
/// @param factor  [front_size(n, rows below)]
void put_tiles(const Ref<const MatrixXd>& L, float* factor);

/// x <- A^-1 x in two halves, front by front: x <- L^-1 x in ascending order, then x <- L'^-1
/// x in descending order.
/// @param n      unknowns of the front
/// @param below  rows below it, 0 for the last front
/// @param x      [tiled(n) + tiled(below)], what is beyond the unknowns finite
void eliminate_tiles(const float* factor, int n, int below, double* x);
void substitute_tiles(const float* factor, int n, int below, double* x);

}  // namespace ffcontact
