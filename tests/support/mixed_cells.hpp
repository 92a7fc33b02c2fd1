// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "support/random.hpp"

/// A cube of hexahedra, prisms and pyramids, as a file of any origin may list them.
namespace ffcontact::test {

inline VectorXi numbers_from(int first, int count) {
  return VectorXi::LinSpaced(count, first, first + count - 1);
}

/// Cells of a cube, which list their corners in any order.
struct MixedCells {
  Matrix3Xd vertices;
  VectorXi numbers;  ///< of the vertices, at random
  std::vector<std::vector<int>> corners;
};

constexpr int hexahedra_a_side = 3;  // hexahedra along an edge of the cube

inline Vector3i place_of_hexahedron(int hexahedron) {
  constexpr int side = hexahedra_a_side;
  return {hexahedron % side, hexahedron / side % side,
          hexahedron / side / side};
}

inline int vertex_at(const Vector3i& place) {
  constexpr int count = hexahedra_a_side + 1;
  return place[0] + count * (place[1] + count * place[2]);
}

/// Vertices, moved by up to `shift`, those of the surface along it; then the middles of
/// the hexahedra.
inline Matrix3Xd vertices_of_cube(double shift, Random& random) {
  constexpr int side = hexahedra_a_side, count = side + 1;
  constexpr int first_middle = count * count * count;
  Matrix3Xd vertices(3, first_middle + side * side * side);
  const auto moved = [&](int place) {
    const double by = shift * random_vector(1, random)[0];
    return place % side == 0 ? place : place + by;
  };
  for (int v = 0; v < first_middle; ++v)
    vertices.col(v) << moved(v % count), moved(v / count % count),
        moved(v / count / count);
  for (int c = 0; c < side * side * side; ++c)
    vertices.col(first_middle + c) =
        place_of_hexahedron(c).cast<double>().array() + 0.5;
  return vertices;
}

/// A hexahedron as gmsh orders its corners, with its axes in any order and direction.
inline std::vector<int> turned_hexahedron(int cell, Random& random) {
  const Vector3i place = place_of_hexahedron(cell);
  Vector3i axes(0, 1, 2);
  std::shuffle(axes.begin(), axes.end(), random);
  const unsigned flips = random();
  std::vector<int> corners;
  for (int k = 0; k < 8; ++k) {
    const int steps[] = {(k & 1) ^ (k >> 1 & 1), k >> 1 & 1, k >> 2};
    Vector3i at = place;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] += steps[axes[axis]] ^ static_cast<int>(flips >> axis & 1);
    corners.push_back(vertex_at(at));
  }
  return corners;
}

using CellList = std::vector<std::vector<int>>;

/// Both ends of a prism, or the base of a pyramid, from any corner on, either way round.
inline std::vector<int> turned(const std::vector<int>& cell, Random& random) {
  const int around = cell.size() == 6 ? 3 : 4, first = random() % around,
            step = random() % 2 ? 1 : around - 1,
            level = cell.size() == 6 && random() % 2 ? 3 : 0;
  std::vector<int> result = cell;
  for (int k = 0; k < around; ++k) {
    const int from = (first + step * k) % around;
    result[k] = cell[from + level];
    if (around == 3) result[k + 3] = cell[from + 3 - level];
  }
  return result;
}

/// Split into prisms along z.
inline CellList in_prisms(int cell) {
  const Vector3i place = place_of_hexahedron(cell);
  const auto at = [&](int x, int y, int z) {
    return vertex_at(place + Vector3i(x, y, z));
  };
  return {{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1),
           at(0, 1, 1)},
          {at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(1, 0, 1), at(1, 1, 1),
           at(0, 1, 1)}};
}

/// Joined to the middle.
inline CellList in_pyramids(int cell, Random& random) {
  const std::vector<int> h = turned_hexahedron(cell, random);
  const int first_middle = vertex_at(Vector3i::Constant(hexahedra_a_side)) + 1,
            middle = first_middle + cell;
  return {{h[0], h[1], h[2], h[3], middle}, {h[4], h[5], h[6], h[7], middle},
          {h[0], h[1], h[5], h[4], middle}, {h[1], h[2], h[6], h[5], middle},
          {h[2], h[3], h[7], h[6], middle}, {h[3], h[0], h[4], h[7], middle}};
}

enum class CellKind { hexahedra, prisms, pyramids, mixed };

inline CellList cells_of_hexahedron(int cell, CellKind kind, Random& random) {
  if (kind == CellKind::hexahedra || (kind == CellKind::mixed && cell % 2 == 0))
    return {turned_hexahedron(cell, random)};
  CellList cells =
      kind == CellKind::prisms ? in_prisms(cell) : in_pyramids(cell, random);
  for (std::vector<int>& corners : cells) corners = turned(corners, random);
  return cells;
}

inline MixedCells cells_of_cube(CellKind kind, double shift, Random& random) {
  constexpr int side = hexahedra_a_side;
  MixedCells cells;
  cells.vertices = vertices_of_cube(shift, random);
  cells.numbers = numbers_from(0, static_cast<int>(cells.vertices.cols()));
  std::shuffle(cells.numbers.begin(), cells.numbers.end(), random);
  for (int c = 0; c < side * side * side; ++c)
    for (const std::vector<int>& corners : cells_of_hexahedron(c, kind, random))
      cells.corners.push_back(corners);
  return cells;
}

}  // namespace ffcontact::test
