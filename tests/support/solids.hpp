// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "support/meshes.hpp"
#include "support/uniform.hpp"

/// Solids that the tests share.
namespace ffcontact::test {

/// Labels of a brick's sides.
enum BrickSide : int { low_x = 1, high_x, low_y, high_y, low_z, high_z };

/// Faces of one tetrahedron only, with the label of the coordinate plane that they lie
/// in.
inline void add_boundary(SolidMesh& mesh) {
  std::map<std::array<int, 3>, int> cells_at;
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k < 4; ++k) {
      std::array<int, 3> face;
      for (int i = 0; i < 3; ++i) face[i] = mesh.cells((k + 1 + i) % 4, t);
      std::sort(face.begin(), face.end());
      ++cells_at[face];
    }
  std::vector<std::array<int, 3>> faces;
  for (const auto& [face, count] : cells_at)
    if (count == 1) faces.push_back(face);
  const auto n = static_cast<Index>(faces.size());
  const Vector3d low = mesh.vertices.rowwise().minCoeff();
  mesh.boundary.resize(3, n);
  mesh.boundary_label.resize(n);
  for (Index f = 0; f < n; ++f) {
    mesh.boundary.col(f) << faces[f][0], faces[f][1], faces[f][2];
    const Matrix3d x = mesh.vertices(Eigen::all, faces[f]);
    for (int c = 0; c < 3; ++c)
      if (x(c, 0) == x(c, 1) && x(c, 0) == x(c, 2))
        mesh.boundary_label[f] = 2 * c + (x(c, 0) == low[c] ? low_x : high_x);
  }
}

/// A brick (0, size) of bricks, each cut into the six tetrahedra of Kuhn: the monotone
/// paths from its lowest to its highest corner.
inline SolidMesh brick(const Vector3i& cells, const Vector3d& size) {
  SolidMesh mesh;
  const auto id = [&](const Vector3i& at) {
    return (at.z() * (cells.y() + 1) + at.y()) * (cells.x() + 1) + at.x();
  };
  mesh.vertices.resize(3, (cells.array() + 1).prod());
  mesh.cells.resize(4, 6 * cells.prod());
  int next = 0;
  for (int k = 0; k <= cells.z(); ++k)
    for (int j = 0; j <= cells.y(); ++j)
      for (int i = 0; i <= cells.x(); ++i) {
        const Vector3i at(i, j, k);
        mesh.vertices.col(id(at)) = size.cwiseProduct(at.cast<double>())
                                        .cwiseQuotient(cells.cast<double>());
        if (((at - cells).array() == 0).any()) continue;
        std::array<int, 3> axes{0, 1, 2};
        do {
          const Vector3i a = at + Vector3i::Unit(axes[0]),
                         b = a + Vector3i::Unit(axes[1]),
                         c = b + Vector3i::Unit(axes[2]);
          const bool even = (axes[0] + 1) % 3 == axes[1];
          mesh.cells.col(next++) << id(at), id(even ? a : b), id(even ? b : a),
              id(c);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  add_boundary(mesh);
  return mesh;
}

/// A brick whose vertices are moved at random, by less than `fraction` of the cell in
/// each direction; those on a side stay on it. The tetrahedra stay positive for fraction
/// < 1/6.
inline SolidMesh moved(SolidMesh mesh, double cell, double fraction,
                       std::mt19937& random) {
  const Uniform shift{-fraction * cell, fraction * cell};
  const Vector3d low = mesh.vertices.rowwise().minCoeff(),
                 high = mesh.vertices.rowwise().maxCoeff();
  for (int v = 0; v < mesh.vertex_count(); ++v)
    for (int c = 0; c < 3; ++c) {
      const double by = shift(random), x = mesh.vertices(c, v);
      if (x > low[c] && x < high[c]) mesh.vertices(c, v) += by;
    }
  return mesh;
}

/// The same body with vertices, tetrahedra, local vertices and labelled faces in random
/// order.
inline SolidMesh shuffled(const SolidMesh& mesh, std::mt19937& random) {
  const auto order = [&random](Index n) {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    shuffle(numbers, random);
    return numbers;
  };
  const std::vector<int> vertex = order(mesh.vertices.cols()),
                         cell = order(mesh.cells.cols()),
                         face = order(mesh.boundary.cols());
  SolidMesh result = mesh;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    result.vertices.col(vertex[v]) = mesh.vertices.col(v);
  for (int t = 0; t < mesh.cell_count(); ++t) {
    // an even permutation keeps the orientation
    const int turn = static_cast<int>(random() % 3),
              kept = static_cast<int>(random() % 4);
    for (int k = 0; k < 3; ++k)
      result.cells((kept + 1 + (k + turn) % 3) % 4, cell[t]) =
          vertex[mesh.cells((kept + 1 + k) % 4, t)];
    result.cells(kept, cell[t]) = vertex[mesh.cells(kept, t)];
  }
  for (Index f = 0; f < mesh.boundary.cols(); ++f) {
    const std::vector<int> corner = order(3);
    for (int k = 0; k < 3; ++k)
      result.boundary(corner[k], face[f]) = vertex[mesh.boundary(k, f)];
    result.boundary_label[face[f]] = mesh.boundary_label[f];
  }
  return result;
}

/// The brick (0, 3) x (0, 2) x (0, 2), moved and in random order.
inline SolidMesh irregular_solid(std::mt19937& random) {
  return shuffled(moved(brick({3, 2, 2}, {3, 2, 2}), 1, 0.15, random), random);
}

using SolidField = std::function<Vector3d(const Vector3d&)>;

inline VectorXd nodal_values(const SolidMesh& mesh, const SolidField& field) {
  VectorXd values(3 * mesh.vertices.cols());
  for (int v = 0; v < mesh.vertex_count(); ++v)
    values.segment<3>(3 * v) = field(mesh.vertices.col(v));
  return values;
}

/// Vertices on the labelled faces of a solid, each once.
inline std::vector<int> vertices_on(const SolidMesh& mesh, int label) {
  std::vector<int> found;
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    if (mesh.boundary_label[f] == label)
      for (int v : mesh.boundary.col(f)) found.push_back(v);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ffcontact::test
