// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/splitting/solid_cell_split.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "ffcontact/base/packed.hpp"
#include "ffcontact/mesh/mesh.hpp"
#include "support/mixed_cells.hpp"
#include "support/random.hpp"

namespace ffcontact {
namespace {

using namespace test;

Matrix3Xd cube_corners() {
  Matrix3Xd x(3, 8);
  x << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,   //
      0, 0, 0, 0, 1, 1, 1, 1;
  return x;
}

Matrix3Xd prism_corners() {
  return cube_corners()(Eigen::all, {0, 1, 3, 4, 5, 7});
}

Matrix3Xd pyramid_corners() {
  Matrix3Xd x(3, 5);
  x << cube_corners().leftCols(4), Vector3d(0.5, 0.5, 1);
  return x;
}

/// Of each tetrahedron.
std::vector<double> volumes_of(const Matrix3Xd& corners,
                               const SolidCellSplit& split) {
  SolidMesh mesh;
  mesh.vertices.resize(3, corners.cols() + 1);
  mesh.vertices << corners, corners.rowwise().mean();
  mesh.cells = packed(split.tetrahedra);
  std::vector<double> volumes;
  for (int t = 0; t < mesh.cell_count(); ++t)
    volumes.push_back(signed_volume(mesh, t));
  return volumes;
}

double smallest(const std::vector<double>& volumes) {
  return *std::min_element(volumes.begin(), volumes.end());
}

void expect_split(const Matrix3Xd& corners, int count, bool has_middle,
                  double volume, double each) {
  const int vertices = static_cast<int>(corners.cols());
  const SolidCellSplit split =
      solid_cell_split(corners, numbers_from(0, vertices));
  ASSERT_EQ(count_of(split.tetrahedra), count);
  EXPECT_EQ(split.has_middle, has_middle);
  const std::vector<double> volumes = volumes_of(corners, split);
  EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), volume,
              1e-14);
  EXPECT_NEAR(smallest(volumes), each, 1e-14);
}

TEST(SolidCellSplit, of_regular_cells) {
  expect_split(cube_corners(), 6, false, 1, 1.0 / 6);
  expect_split(prism_corners(), 3, false, 0.5, 1.0 / 6);
  expect_split(pyramid_corners(), 2, false, 1.0 / 3, 1.0 / 6);
}

TEST(SolidCellSplit, of_mirrored_cells) {
  const Vector3d mirror(-1, 1, 1);
  expect_split(mirror.asDiagonal() * cube_corners(), 6, false, 1, 1.0 / 6);
  expect_split(mirror.asDiagonal() * prism_corners(), 3, false, 0.5, 1.0 / 6);
  expect_split(mirror.asDiagonal() * pyramid_corners(), 2, false, 1.0 / 3,
               1.0 / 6);
}

/// The shortest diagonals of acute corners go around them, and none meet.
TEST(SolidCellSplit, is_two_prisms_of_cells_skewed_alike_in_three_directions) {
  const Matrix3d skew = Matrix3d::Identity() + Matrix3d::Constant(0.2);
  for (const double sign : {1.0, -1.0}) {
    const Matrix3d map = sign * skew;
    expect_split(map * cube_corners(), 6, false, skew.determinant(),
                 skew.determinant() / 6);
  }
}

/// Slivers in warped faces, which tell corners from each other, do not take their place.
RC_GTEST_PROP(SolidCellSplit,
              of_such_cells_that_are_warped_a_little_has_no_slivers,
              (Random random)) {
  const Matrix3d skew = Matrix3d::Identity() + Matrix3d::Constant(0.2);
  const Matrix3Xd corners =
      skew * cube_corners() + 1e-4 * random_matrix(3, 8, random);
  const SolidCellSplit split = solid_cell_split(corners, numbers_from(0, 8));
  RC_ASSERT(count_of(split.tetrahedra) == 6);
  RC_ASSERT(smallest(volumes_of(corners, split)) > 0.2);
}

/// Of all ways the one with the largest smallest tetrahedron is taken.
RC_GTEST_PROP(SolidCellSplit, is_as_good_in_any_order_of_corners,
              (Random random)) {
  const MixedCells cells = cells_of_cube(CellKind::hexahedra, 0.2, random);
  for (int cell = 0; cell < count_of(cells.corners); ++cell) {
    const auto smallest_of = [&](const std::vector<int>& order) {
      const Matrix3Xd corners = cells.vertices(Eigen::all, order);
      return smallest(
          volumes_of(corners, solid_cell_split(corners, cells.numbers(order))));
    };
    const double wanted = smallest_of(cells.corners[cell]);
    RC_ASSERT(std::abs(smallest_of(turned_hexahedron(cell, random)) - wanted) <
              1e-8);
  }
}

/// The upper half of the corners turned about the middle.
Matrix3Xd twisted(const Matrix3Xd& corners, double angle) {
  const Index half = corners.cols() / 2;
  const Matrix3d turn =
      Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d middle = corners.rightCols(half).rowwise().mean();
  Matrix3Xd result = corners;
  for (Index k = half; k < corners.cols(); ++k)
    result.col(k) = middle + turn * (corners.col(k) - middle);
  return result;
}

Matrix3Xd regular_prism() {
  Matrix3Xd corners(3, 6);
  for (int k = 0; k < 6; ++k) {
    const double angle = 2 * M_PI / 3 * (k % 3);
    corners.col(k) << std::cos(angle), std::sin(angle), k / 3;
  }
  return corners;
}

/// Diagonals that all go around the sides one way are Schoenhardt's of a prism.
TEST(SolidCellSplit, has_a_middle_where_there_is_no_other_way) {
  for (const double angle : {0.2, -0.2})
    for (const Matrix3Xd& corners : {regular_prism(), cube_corners()}) {
      const Matrix3Xd cell = twisted(corners, angle);
      const int count = static_cast<int>(cell.cols());
      const SolidCellSplit split =
          solid_cell_split(cell, numbers_from(0, count));
      EXPECT_TRUE(split.has_middle);
      EXPECT_EQ(count_of(split.tetrahedra), count == 6 ? 8 : 12);
      for (const double volume : volumes_of(cell, split))
        EXPECT_GT(volume, 0.04);
    }
}

/// Seen along no edge and no face: all quadrangles keep their areas.
Matrix3Xd flattened(const Matrix3Xd& corners, double thickness) {
  const Vector3d direction = Vector3d(1, 2, 3).normalized();
  return (Matrix3d::Identity() -
          (1 - thickness) * direction * direction.transpose()) *
         corners;
}

bool is_refused(const Matrix3Xd& corners) {
  const int count = static_cast<int>(corners.cols());
  return solid_cell_split(corners, numbers_from(0, count)).tetrahedra.empty();
}

TEST(SolidCellSplit, is_none_of_flat_cells) {
  for (const Matrix3Xd& cell :
       {cube_corners(), prism_corners(), pyramid_corners()}) {
    EXPECT_TRUE(is_refused(flattened(cell, 1e-14)));
    EXPECT_FALSE(is_refused(flattened(cell, 1e-6)));
  }
}

TEST(SolidCellSplit, is_none_of_folded_cells) {
  for (const std::vector<int>& order :
       {std::vector<int>{0, 1, 2, 3, 6, 7, 4, 5}, {1, 0, 2, 3, 4, 5, 6, 7}})
    EXPECT_TRUE(is_refused(cube_corners()(Eigen::all, order)));
  Matrix3Xd collapsed = cube_corners();
  collapsed.col(5) = collapsed.col(4);
  EXPECT_TRUE(is_refused(collapsed));
}

struct Tetrahedra {
  std::map<std::array<int, 3>, int> cells_of_face;
  double volume = 0, smallest = 1;
  int middles = 0, refused = 0;
};

Tetrahedra tetrahedra_of(const MixedCells& cells) {
  Tetrahedra result;
  for (const std::vector<int>& cell : cells.corners) {
    const Matrix3Xd corners = cells.vertices(Eigen::all, cell);
    const SolidCellSplit split = solid_cell_split(corners, cells.numbers(cell));
    for (const double volume : volumes_of(corners, split)) {
      result.volume += volume;
      result.smallest = std::min(result.smallest, volume);
    }
    result.refused += split.tetrahedra.empty();
    result.middles += split.has_middle;
    const int middle = 1000 + result.middles;
    for (const Vector4i& t : split.tetrahedra)
      for (int opposite = 0; opposite < 4; ++opposite) {
        std::array<int, 3> face;
        for (int k = 0; k < 3; ++k) {
          const int corner = t[(opposite + 1 + k) % 4];
          face[k] = corner == count_of(cell) ? middle : cell[corner];
        }
        std::sort(face.begin(), face.end());
        ++result.cells_of_face[face];
      }
  }
  return result;
}

/// Each inner face twice, those of the cube once; the volume is that of the cube.
void require_conforming(const Tetrahedra& found) {
  constexpr int side = hexahedra_a_side;
  int once = 0;
  for (const auto& [face, count] : found.cells_of_face) {
    RC_ASSERT(count == 1 || count == 2);
    once += count == 1;
  }
  RC_ASSERT(once == 6 * 2 * side * side);
  RC_ASSERT(std::abs(found.volume - side * side * side) < 1e-11);
  RC_ASSERT(found.smallest > 0);
}

RC_GTEST_PROP(SolidCellSplit, of_bricks_is_conforming_without_new_vertices,
              (Random random)) {
  for (const CellKind kind : {CellKind::hexahedra, CellKind::prisms,
                              CellKind::pyramids, CellKind::mixed}) {
    const Tetrahedra found = tetrahedra_of(cells_of_cube(kind, 0, random));
    require_conforming(found);
    RC_ASSERT(found.middles == 0);
  }
}

RC_GTEST_PROP(SolidCellSplit, of_warped_cells_is_conforming, (Random random)) {
  const double shift = *real(0, 0.2);
  for (const CellKind kind : {CellKind::hexahedra, CellKind::prisms,
                              CellKind::pyramids, CellKind::mixed}) {
    const Tetrahedra found = tetrahedra_of(cells_of_cube(kind, shift, random));
    RC_ASSERT(found.refused == 0);
    require_conforming(found);
  }
}

}  // namespace
}  // namespace ffcontact
