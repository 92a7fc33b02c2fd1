// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/face_forms.hpp"

#include <Eigen/LU>
#include <array>

#include "ffcontact/equilibrium/face_tractions.hpp"

namespace ffcontact {

namespace {

using Matrix36f = Matrix<float, 36, 36>;
using Matrix6f = Matrix<float, 6, 6>;
using Matrix4f = Matrix<float, 4, 4>;

constexpr int free_unknowns = FaceForms::free_unknowns,
              tiles = tiled(free_unknowns) / tile_size, none = -1;

/// Where an entry of the lower triangle is in its tiles.
constexpr int place_in_tiles(int row, int column) {
  const int I = row / tile_size, J = column / tile_size;
  return numbers_in_tile * (tiles * J - J * (J - 1) / 2 + I - J) +
         tile_size * (column % tile_size) + row % tile_size;
}

/// Where an unknown of a face is in z.
constexpr int place_in_z(int face, int unknown, int dependent) {
  const int after = (face - dependent + 3) % 4;
  if (face != dependent) return 9 * after + unknown;
  return unknown < 6 ? none : 27 + unknown - 6;
}

struct Places {
  /// Of z in x and of x in z, for each dependent face.
  std::array<std::array<int, free_unknowns>, 4> in_x{};
  std::array<std::array<int, 36>, 4> in_z{};
  /// Of the entries of a form in its tiles.
  std::array<std::array<int, free_unknowns>, free_unknowns> in_tiles{};

  constexpr Places() {
    for (int d = 0; d < 4; ++d)
      for (int i = 0; i < 36; ++i) {
        in_z[d][i] = place_in_z(i / 9, i % 9, d);
        if (in_z[d][i] != none) in_x[d][in_z[d][i]] = i;
      }
    for (int r = 0; r < free_unknowns; ++r)
      for (int c = 0; c < free_unknowns; ++c)
        in_tiles[r][c] = r >= c ? place_in_tiles(r, c) : place_in_tiles(c, r);
  }
};

constexpr Places places;

int largest_face(const TetrahedronCorners& corners) {
  int largest = 0;
  face_vectors(corners).colwise().squaredNorm().maxCoeff(&largest);
  return largest;
}

/// T' H T at the places of H; what is left for w_d means nothing.
Matrix36f balanced_form(const SolidTopology& topology, int cell, int d,
                        Matrix36f H) {
  for (int k = 0; k < 4; ++k) {
    if (k == d) continue;
    const Matrix6f shift =
        balancing_shift(topology, cell, k, d).matrix().cast<float>();
    H.middleCols<6>(9 * k) += H.middleCols<6>(9 * d).lazyProduct(shift);
    H.middleRows<6>(9 * k) +=
        shift.transpose().lazyProduct(H.middleRows<6>(9 * d));
  }
  return H;
}

}  // namespace

FaceForms::FaceForms(const SolidTopology& topology,
                     const HookeTensors<3>& hooke)
    : dependent_(topology.mesh.cell_count()) {
  forms_.reset(new float[stored * topology.mesh.cell_count()]);
#pragma omp parallel for
  for (int t = 0; t < topology.mesh.cell_count(); ++t) {
    const TetrahedronCorners corners = corners_of(topology.mesh, t);
    const int d = largest_face(corners);
    dependent_[t] = static_cast<char>(d);
    put_form(balanced_form(topology, t, d,
                           rough_face_energy(corners, hooke[t].inverse(),
                                             wrench_bases(topology, t))),
             t);
  }
}

void FaceForms::put_form(const Matrix36f& H, int cell) {
  const auto& in_x = places.in_x[dependent_[cell]];
  Matrix<float, tiled(free_unknowns), tiled(free_unknowns)> form;
  form.setZero();
  form.topLeftCorner<free_unknowns, free_unknowns>() = H(in_x, in_x);
  form.triangularView<Eigen::StrictlyUpper>() = form.transpose();
  float* next = forms_.get() + stored * cell;
  for (int J = 0; J < tiles; ++J)
    for (int I = J; I < tiles; ++I, next += numbers_in_tile)
      Map<Matrix4f>{next} = form.block<4, 4>(4 * I, 4 * J);
}

FaceForms::InTiles FaceForms::product(int cell, const InTiles& z) const {
  const float* next = form(cell);
  InTiles y = InTiles::Zero();
  for (int J = 0; J < tiles; ++J) {
    const Vector4d z_J = z.segment<4>(4 * J);
    // of the transposed form, column by column; the tile on the diagonal counts once
    Matrix4d below = Matrix4d::Zero();
    y.segment<4>(4 * J) += tile_at(next) * z_J;
    next += numbers_in_tile;
    for (int I = J + 1; I < tiles; ++I, next += numbers_in_tile) {
      const Matrix4d tile = tile_at(next);
      const Vector4d z_I = z.segment<4>(4 * I);
      y.segment<4>(4 * I) += tile * z_J;
      below.array() += tile.array().colwise() * z_I.array();
    }
    y.segment<4>(4 * J) += below.colwise().sum().transpose();
  }
  return y;
}

Vector36d FaceForms::times(int cell, const Vector36d& x) const {
  const auto& in_x = places.in_x[dependent_[cell]];
  InTiles z = InTiles::Zero();
  z.head<free_unknowns>() = x(in_x);
  const InTiles of_z = product(cell, z);
  Vector36d y = Vector36d::Zero();
  y(in_x) = of_z.head<free_unknowns>();
  return y;
}

Matrix<float, 9, 9> FaceForms::block(int cell, int k, int l) const {
  const float* H = form(cell);
  const auto& in_z = places.in_z[dependent_[cell]];
  Matrix<float, 9, 9> block;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) {
      const int row = in_z[9 * k + i], column = in_z[9 * l + j];
      const bool is_free = row != none && column != none;
      block(i, j) = is_free ? H[places.in_tiles[row][column]] : 0;
    }
  return block;
}

}  // namespace ffcontact
