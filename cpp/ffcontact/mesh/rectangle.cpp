// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/mesh/rectangle.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// Vertices of a rectangle, row by row.
struct Lattice {
  Vector2i cells;

  int operator()(int i, int j) const { return j * (cells.x() + 1) + i; }
};

void require_extent(const Vector2i& cells, const Vector2d& size) {
  if (cells.minCoeff() < 1)
    refuse("a rectangle has at least one cell each way, got ", cells.x(), " x ",
           cells.y());
  if (!(size.minCoeff() > 0 && size.allFinite()))
    refuse("the sides of a rectangle are positive, got ", size.x(), " and ",
           size.y());
}

/// The edges of the four sides, counter-clockwise.
void put_sides(const Lattice& at, Mesh& mesh) {
  const int nx = at.cells.x(), ny = at.cells.y();
  mesh.boundary.resize(2, 2 * (nx + ny));
  mesh.boundary_label.resize(2 * (nx + ny));
  int next = 0;
  const auto put = [&](int a, int b, int label) {
    mesh.boundary.col(next) << a, b;
    mesh.boundary_label[next++] = label;
  };
  for (int i = 0; i < nx; ++i) put(at(i, 0), at(i + 1, 0), 1);
  for (int j = 0; j < ny; ++j) put(at(nx, j), at(nx, j + 1), 2);
  for (int i = nx; i > 0; --i) put(at(i, ny), at(i - 1, ny), 3);
  for (int j = ny; j > 0; --j) put(at(0, j), at(0, j - 1), 4);
}

}  // namespace

Mesh rectangle(const Vector2i& cells, const Vector2d& size) {
  require_extent(cells, size);
  const int nx = cells.x(), ny = cells.y();
  const Lattice at{cells};
  Mesh mesh;
  mesh.vertices.resize(2, (nx + 1) * (ny + 1));
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i)
      mesh.vertices.col(at(i, j)) << size.x() * i / nx, size.y() * j / ny;
  mesh.cells.resize(3, 2 * nx * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = at(i, j), b = a + 1, c = at(i + 1, j + 1), d = c - 1;
      mesh.cells.middleCols<2>(2 * (j * nx + i)) << a, a, b, c, c, d;
    }
  put_sides(at, mesh);
  return mesh;
}

}  // namespace ffcontact
