// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/tiled_factor.hpp"

#include <algorithm>

namespace ffcontact {

namespace {

using Tile = Matrix<float, tile_size, tile_size>;
using PartOfTile = Matrix<double, tile_size, 1>;

Map<PartOfTile> part_at(double* x, int tile) {
  return Map<PartOfTile>(x + tile_size * tile);
}

Tile inverse_of_lower(const Tile& L) {
  Tile inverse = Tile::Zero();
  for (int j = 0; j < tile_size; ++j) {
    inverse(j, j) = 1 / L(j, j);
    for (int i = j + 1; i < tile_size; ++i)
      inverse(i, j) =
          -L.row(i).segment(j, i - j).dot(inverse.col(j).segment(j, i - j)) /
          L(i, i);
  }
  return inverse;
}

/// The tile of entries (I.., J..) of n columns and the rows below them.
Tile tile_of(const Ref<const MatrixXd>& L, int first_row, int rows, int J) {
  const auto n = static_cast<int>(L.cols());
  const bool on_diagonal = first_row == J;
  Tile tile = Tile::Zero();
  if (on_diagonal) tile.setIdentity();
  for (int j = J; j < std::min(n, J + tile_size); ++j)
    for (int i = on_diagonal ? j - J : 0; i < rows; ++i)
      tile(i, j - J) = static_cast<float>(L(first_row + i, j));
  return on_diagonal ? inverse_of_lower(tile) : tile;
}

}  // namespace

void put_tiles(const Ref<const MatrixXd>& L, float* factor) {
  const auto n = static_cast<int>(L.cols()), all = static_cast<int>(L.rows());
  const auto put = [&](int I, int end, int J) {
    Map<Tile>{factor} = tile_of(L, I, std::min(tile_size, end - I), J);
    factor += numbers_in_tile;
  };
  for (int J = 0; J < n; J += tile_size) {
    for (int I = J; I < n; I += tile_size) put(I, n, J);
    for (int I = n; I < all; I += tile_size) put(I, all, J);
  }
}

void eliminate_tiles(const float* factor, int n, int below, double* x) {
  const int own = tiled(n) / tile_size, all = own + tiled(below) / tile_size;
  for (int J = 0; J < own; ++J) {
    const PartOfTile x_J = tile_at(factor) * part_at(x, J);
    part_at(x, J) = x_J;
    factor += numbers_in_tile;
    for (int I = J + 1; I < all; ++I, factor += numbers_in_tile)
      part_at(x, I) -= tile_at(factor) * x_J;
  }
}

void substitute_tiles(const float* factor, int n, int below, double* x) {
  const int own = tiled(n) / tile_size, all = own + tiled(below) / tile_size;
  const float* next = factor + front_size(n, below);
  for (int J = own - 1; J >= 0; --J) {
    next -= numbers_in_tile * (all - J);
    Matrix4d products =
        Matrix4d::Zero();  // of the columns below the diagonal with x
    for (int I = J + 1; I < all; ++I)
      products.array() +=
          tile_at(next + numbers_in_tile * (I - J)).array().colwise() *
          part_at(x, I).array();
    const PartOfTile left =
        part_at(x, J) - products.colwise().sum().transpose();
    part_at(x, J) = tile_at(next).transpose() * left;
  }
}

}  // namespace ffcontact
