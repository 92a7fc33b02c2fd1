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

}  // namespace

void put_tiles(const Ref<const MatrixXd>& L, float* factor) {
  const auto n = static_cast<int>(L.rows());
  for (int J = 0; J < n; J += tile_size)
    for (int I = J; I < n; I += tile_size, factor += numbers_in_tile) {
      Tile tile = Tile::Identity();
      if (I > J) tile.setZero();
      for (int j = J; j < std::min(n, J + tile_size); ++j)
        for (int i = std::max(I, j); i < std::min(n, I + tile_size); ++i)
          tile(i - I, j - J) = static_cast<float>(L(i, j));
      Map<Tile>{factor} = I == J ? inverse_of_lower(tile) : tile;
    }
}

void solve_tiles(const float* factor, int n, double* x) {
  const int tiles = tiled(n) / tile_size;
  const float* next = factor;
  for (int J = 0; J < tiles; ++J) {
    const PartOfTile x_J = tile_at(next) * part_at(x, J);
    part_at(x, J) = x_J;
    next += numbers_in_tile;
    for (int I = J + 1; I < tiles; ++I, next += numbers_in_tile)
      part_at(x, I) -= tile_at(next) * x_J;
  }
  for (int J = tiles - 1; J >= 0; --J) {
    next -= numbers_in_tile * (tiles - J);
    Matrix4d products =
        Matrix4d::Zero();  // of the columns below the diagonal with x
    for (int I = J + 1; I < tiles; ++I)
      products.array() +=
          tile_at(next + numbers_in_tile * (I - J)).array().colwise() *
          part_at(x, I).array();
    const PartOfTile left =
        part_at(x, J) - products.colwise().sum().transpose();
    part_at(x, J) = tile_at(next).transpose() * left;
  }
}

}  // namespace ffcontact
