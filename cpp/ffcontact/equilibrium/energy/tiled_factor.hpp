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

/// Numbers in the factor of n unknowns.
constexpr Index factor_size(int n) {
  const Index tiles = tiled(n) / tile_size;
  return numbers_in_tile * tiles * (tiles + 1) / 2;
}

/// A tile as it is multiplied.
template <class Scalar>
Matrix4d tile_at(const Scalar* numbers) {
  return Map<const Matrix<Scalar, tile_size, tile_size>>(numbers)
      .template cast<double>();
}

/// @param L       lower triangle of n unknowns
/// @param factor  [factor_size(n)]
void put_tiles(const Ref<const MatrixXd>& L, float* factor);

/// x <- A^-1 x
/// @param n  unknowns
/// @param x  [tiled(n)], what is beyond n unknowns finite
void solve_tiles(const float* factor, int n, double* x);

}  // namespace ffcontact
