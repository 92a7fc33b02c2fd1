// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A conforming triangulation of a plane body, as FreeFEM keeps it.
struct Mesh {
  Matrix2Xd vertices;  ///< coordinates [mm]
  Matrix3Xi cells;     ///< vertices of each triangle, counter-clockwise
  /// vertex pairs of the labelled edges, either direction; inner ones are allowed
  Matrix2Xi boundary;
  VectorXi boundary_label;  ///< one label per column of `boundary`
  /// Where the coordinates' zero lies for who reads messages; apart from those nothing
  /// depends on it.
  Vector2d origin = Vector2d::Zero();

  int vertex_count() const { return static_cast<int>(vertices.cols()); }
  int cell_count() const { return static_cast<int>(cells.cols()); }
  /// A vertex as who made the mesh knows it.
  Vector2d place(int vertex) const { return origin + vertices.col(vertex); }
  Vector2d corner(int triangle, int k) const { return vertices.col(cells(k, triangle)); }
};

/// Area of one triangle [mm^2], positive when counter-clockwise.
double signed_area(const Mesh& mesh, int triangle);

/// Columns are the gradients [1/mm] of the three hat functions on one triangle.
Matrix<double, 2, 3> hat_gradients(const Mesh& mesh, int triangle);

/// @throws std::invalid_argument  if the mesh is empty, an index is out of range, a
///                                coordinate is not finite,
///                                or a triangle has no positive area
void require_valid(const Mesh& mesh);

}  // namespace ffcontact
