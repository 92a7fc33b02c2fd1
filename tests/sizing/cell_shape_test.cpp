// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/sizing/cell_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cells.hpp"
#include "support/solids.hpp"

namespace ffcontact::test {
namespace {

SolidMesh single_tetrahedron(const Matrix<double, 3, 4>& corners) {
  SolidMesh mesh;
  mesh.vertices = corners;
  mesh.cells = Eigen::Vector4i(0, 1, 2, 3);
  return mesh;
}

TEST(CellShape, of_regular_simplices_is_one) {
  CellCorners<2> triangle;
  triangle << 0, 1, 0.5, 0, 0, std::sqrt(0.75);
  EXPECT_NEAR(shape_quality(single_triangle(3 * triangle))[0], 1, 1e-15);
  EXPECT_NEAR(regular_volume<2>(), signed_area(single_triangle(triangle), 0),
              1e-15);
  // every other corner of a cube
  Matrix<double, 3, 4> corners;
  corners << 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1;
  const SolidMesh tetrahedron = single_tetrahedron(corners);
  EXPECT_NEAR(shape_quality(tetrahedron)[0], 1, 1e-15);
  EXPECT_NEAR(regular_volume<3>() * std::pow(2, 1.5),
              signed_volume(tetrahedron, 0), 1e-15);
}

TEST(CellShape, of_halves_of_squares_and_sixths_of_cubes) {
  EXPECT_NEAR(shape_quality(rectangle(2, 3, 2, 3)).minCoeff(),
              std::pow(0.75, 0.25), 1e-15);
  const VectorXd sixths = shape_quality(brick({2, 1, 1}, {2, 1, 1}));
  const double exact = std::sqrt(0.6 * std::cbrt(2));
  EXPECT_NEAR(sixths.minCoeff(), exact, 1e-15);
  EXPECT_NEAR(sixths.maxCoeff(), exact, 1e-15);
}

TEST(CellShape, mean_edges_are_the_roots_of_mean_squares) {
  EXPECT_NEAR(mean_edges(rectangle(1, 1, 3, 4))[0], std::sqrt(50 / 3.0), 1e-14);
  // of a sixth of a cube: three sides, two diagonals of squares, that of the cube
  EXPECT_NEAR(mean_edges(brick({1, 1, 1}, {2, 2, 2}))[0],
              2 * std::sqrt(10 / 6.0), 1e-14);
}

TEST(CellShape, size_is_the_edge_of_the_regular_simplex) {
  EXPECT_NEAR(size_of_volume<2>(regular_volume<2>() * 49), 7, 1e-14);
  EXPECT_NEAR(size_of_volume<3>(regular_volume<3>() * 343), 7, 1e-14);
}

RC_GTEST_PROP(CellShape, is_below_one_whatever_the_size, (Random random)) {
  const double scale = *real(1e-3, 1e3);
  const CellCorners<2> triangle = random_cell<2>(random);
  const double plane = shape_quality(single_triangle(triangle))[0];
  RC_ASSERT(plane < 1 && plane > 0);
  RC_ASSERT(std::abs(shape_quality(single_triangle(scale * triangle))[0] -
                     plane) < 1e-13);
  const CellCorners<3> corners = random_cell<3>(random);
  const double solid = shape_quality(single_tetrahedron(corners))[0];
  RC_ASSERT(solid < 1 && solid > 0);
  RC_ASSERT(std::abs(shape_quality(single_tetrahedron(scale * corners))[0] -
                     solid) < 1e-13);
}

}  // namespace
}  // namespace ffcontact::test
