// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_forms.hpp"

#include <Eigen/LU>
#include <array>

#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

namespace {

using Matrix36f = Matrix<float, 36, 36>;
using Matrix4f = Matrix<float, 4, 4>;

Matrix4d tile_at(const float* numbers) {
  return Map<const Matrix4f>(numbers).cast<double>();
}

/// Where an entry of the lower triangle is in its tiles.
constexpr int place_in_tiles(int row, int column) {
  const int I = row / 4, J = column / 4;
  return 16 * (9 * J - J * (J - 1) / 2 + I - J) + 4 * (column % 4) + row % 4;
}

struct PlacesInTiles {
  std::array<std::array<int, 36>, 36> at{};
  constexpr PlacesInTiles() {
    for (int r = 0; r < 36; ++r)
      for (int c = 0; c < 36; ++c)
        at[r][c] = r >= c ? place_in_tiles(r, c) : place_in_tiles(c, r);
  }
};

}  // namespace

FaceForms::FaceForms(const SolidTopology& topology,
                     const HookeTensors<3>& hooke) {
  const int cells = topology.mesh.cell_count();
  forms_.reset(new float[static_cast<std::size_t>(packed) * cells]);
#pragma omp parallel for
  for (int t = 0; t < cells; ++t) {
    const Matrix36f H =
        rough_face_energy(corners_of(topology.mesh, t), hooke[t].inverse(),
                          wrench_bases(topology, t));
    float* next = forms_.get() + static_cast<std::size_t>(packed) * t;
    for (int J = 0; J < tiles; ++J)
      for (int I = J; I < tiles; ++I, next += 16)
        Map<Matrix4f>{next} = H.block<4, 4>(4 * I, 4 * J);
  }
}

Vector36d FaceForms::times(int cell, const Vector36d& x) const {
  const float* next = form(cell);
  Vector36d y = Vector36d::Zero();
  for (int J = 0; J < tiles; ++J) {
    const Vector4d x_J = x.segment<4>(4 * J);
    // of H' x, column by column; the tile on the diagonal counts once
    Matrix4d below = Matrix4d::Zero();
    y.segment<4>(4 * J) += tile_at(next) * x_J;
    next += 16;
    for (int I = J + 1; I < tiles; ++I, next += 16) {
      const Matrix4d tile = tile_at(next);
      const Vector4d x_I = x.segment<4>(4 * I);
      y.segment<4>(4 * I) += tile * x_J;
      below.array() += tile.array().colwise() * x_I.array();
    }
    y.segment<4>(4 * J) += below.colwise().sum().transpose();
  }
  return y;
}

Matrix<float, 9, 9> FaceForms::block(int cell, int k, int l) const {
  static constexpr PlacesInTiles places;
  const float* H = form(cell);
  Matrix<float, 9, 9> block;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i)
      block(i, j) = H[places.at[9 * k + i][9 * l + j]];
  return block;
}

}  // namespace ffcontact
