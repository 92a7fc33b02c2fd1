// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tiled_factor.hpp"

#include <Eigen/LU>

namespace ffcontact {

namespace {

using Tile = Matrix<float, tile_size, tile_size>;
using PartOfTile = Matrix<float, tile_size, 1>;
constexpr int numbers_in_tile = tile_size * tile_size;

Map<const Tile> tile_at(const float* numbers) {
  return Map<const Tile>(numbers);
}
Map<PartOfTile> part_at(float* x, int tile) {
  return Map<PartOfTile>(x + tile_size * tile);
}

}  // namespace

void put_tiles(const MatrixXd& L, float* factor) {
  const auto n = static_cast<int>(L.rows());
  const int tiles = tiled(n) / tile_size;
  MatrixXd whole = MatrixXd::Identity(tiled(n), tiled(n));
  whole.topLeftCorner(n, n) = L.triangularView<Eigen::Lower>();
  for (int J = 0; J < tiles; ++J)
    for (int I = J; I < tiles; ++I, factor += numbers_in_tile) {
      const Matrix4d tile =
          whole.block<tile_size, tile_size>(tile_size * I, tile_size * J);
      const Matrix4d stored =
          I == J ? Matrix4d(tile.triangularView<Eigen::Lower>().solve(
                       Matrix4d::Identity()))
                 : tile;
      Map<Tile>{factor} = stored.cast<float>();
    }
}

void solve_tiles(const float* factor, int n, float* x) {
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
    Tile products = Tile::Zero();  // of the columns below the diagonal with x
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
