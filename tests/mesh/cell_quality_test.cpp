// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/cell_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cells.hpp"
#include "support/solids.hpp"

namespace ffcontact {
namespace {

using namespace test;

TEST(CellQuality, is_one_for_regular_cells) {
  SolidMesh mesh;
  mesh.vertices =
      3 * (Matrix<double, 3, 4>() << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1)
              .finished();
  mesh.cells = (Matrix<int, 4, 1>() << 0, 1, 2, 3).finished();
  if (signed_volume(mesh, 0) < 0) std::swap(mesh.cells(2, 0), mesh.cells(3, 0));
  EXPECT_NEAR(cell_quality(mesh)[0], 1, 1e-14);
  Mesh plane = rectangle(1, 1, 1, 1);
  EXPECT_NEAR(cell_quality(plane)[0],
              std::sqrt(12) * (1 - std::sqrt(0.5)) / std::sqrt(2), 1e-14);
}

TEST(CellQuality, of_sixths_of_cubes) {
  const VectorXd quality = cell_quality(brick({1, 2, 1}, {3, 6, 3}));
  const double exact = std::sqrt(2.0) / (1 + std::sqrt(2.0));
  EXPECT_NEAR(quality.minCoeff(), exact, 1e-14);
  EXPECT_NEAR(quality.maxCoeff(), exact, 1e-14);
}

/// Twice the area over the perimeter, by Heron's sides.
RC_GTEST_PROP(CellQuality, is_the_inscribed_circle_over_the_longest_edge,
              (Random random)) {
  const CellCorners<2> corners = random_cell<2>(random);
  const Mesh mesh = single_triangle(corners);
  double perimeter = 0, longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double side = (corners.col(k) - corners.col((k + 1) % 3)).norm();
    perimeter += side;
    longest = std::max(longest, side);
  }
  const double radius = 2 * signed_area(mesh, 0) / perimeter;
  RC_ASSERT(std::abs(cell_quality(mesh)[0] -
                     std::sqrt(12.0) * radius / longest) < 1e-13);
}

}  // namespace
}  // namespace ffcontact
