// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// A conforming mesh of simplices as FreeFEM keeps it: triangles of a plane body (dim =
/// 2), tetrahedra of a solid (dim = 3). What is said of facets is said of edges in the
/// plane and of faces in space.
template <int dim>
struct SimplexMesh {
  using Point = VectorOf<dim>;

  Matrix<double, dim, Dynamic> vertices;  ///< coordinates [mm]
  /// vertices of each cell, in an order of positive volume (counter-clockwise triangles)
  Matrix<int, dim + 1, Dynamic> cells;
  /// vertices of the labelled facets, in any order; inner facets are allowed
  Matrix<int, dim, Dynamic> boundary;
  VectorXi boundary_label;  ///< one label per column of `boundary`
  /// Where the coordinates' zero lies for who reads messages; apart from those nothing
  /// depends on it.
  Point origin = Point::Zero();

  int vertex_count() const { return static_cast<int>(vertices.cols()); }
  int cell_count() const { return static_cast<int>(cells.cols()); }
  /// A vertex as who made the mesh knows it.
  Point place(int vertex) const { return origin + vertices.col(vertex); }
  Point corner(int cell, int k) const { return vertices.col(cells(k, cell)); }
};

using Mesh = SimplexMesh<2>;
using SolidMesh = SimplexMesh<3>;

/// What the parts of a mesh are called in messages.
template <int dim>
struct MeshWords;
template <>
struct MeshWords<2> {
  static constexpr auto cell = "triangle", cells = "triangles", facet = "edge",
                        volume = "area";
};
template <>
struct MeshWords<3> {
  static constexpr auto cell = "tetrahedron", cells = "tetrahedra",
                        facet = "face", volume = "volume";
};

/// Local vertices of the facet opposite to each local vertex of a cell, in the order in
/// which facet_vector points outward.
template <int dim>
constexpr std::array<std::array<int, dim>, dim + 1> facet_corners{};
template <>
inline constexpr std::array<std::array<int, 2>, 3> facet_corners<2>{
    {{1, 2}, {2, 0}, {0, 1}}};
template <>
inline constexpr std::array<std::array<int, 3>, 4> facet_corners<3>{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The normal of a facet, as long as the facet is large: the vector between two points
/// turned clockwise [mm], or half the vector product of two sides of a triangle, which
/// runs counter-clockwise where the normal points to [mm^2].
/// @param corners  one column each
inline Vector2d facet_vector(const Matrix2d& corners) {
  const Vector2d along = corners.col(1) - corners.col(0);
  return {along.y(), -along.x()};
}
inline Vector3d facet_vector(const Matrix3d& corners) {
  const Vector3d a = corners.col(1) - corners.col(0);
  const Vector3d b = corners.col(2) - corners.col(0);
  return a.cross(b) / 2;
}

/// The corners of a facet, one column each.
template <int dim>
MatrixOf<dim> facet_points(const SimplexMesh<dim>& mesh,
                           const Matrix<int, dim, 1>& vertices) {
  return mesh.vertices(Eigen::all, vertices);
}

/// The corners of a cell, one column each.
template <int dim>
using CellCorners = Matrix<double, dim, dim + 1>;
template <int dim>
CellCorners<dim> corners_of(const SimplexMesh<dim>& mesh, int cell) {
  CellCorners<dim> corners;
  for (int k = 0; k <= dim; ++k) corners.col(k) = mesh.corner(cell, k);
  return corners;
}

template <int dim>
VectorOf<dim> centroid_of(const SimplexMesh<dim>& mesh, int cell) {
  return corners_of(mesh, cell).rowwise().mean();
}

/// Diagonal of the box around the mesh [mm].
template <int dim>
double extent_of(const SimplexMesh<dim>& mesh) {
  return (mesh.vertices.rowwise().maxCoeff() -
          mesh.vertices.rowwise().minCoeff())
      .norm();
}

/// Length [mm] or area [mm^2] of a labelled facet, a column of `boundary`.
template <int dim>
double boundary_measure(const SimplexMesh<dim>& mesh, Index column);

/// Volume of one cell [mm^dim], positive in the order that SimplexMesh::cells asks for.
template <int dim>
double signed_volume(const SimplexMesh<dim>& mesh, int cell);

/// Area of one triangle [mm^2], positive when counter-clockwise.
inline double signed_area(const Mesh& mesh, int triangle) {
  return signed_volume(mesh, triangle);
}

/// Columns are the gradients [1/mm] of the hat functions on one cell: with the outward
/// vectors A_k n_k of its facets, grad phi_k = -A_k n_k / (dim |T|).
template <int dim>
Matrix<double, dim, dim + 1> hat_gradients(const SimplexMesh<dim>& mesh,
                                           int cell);

/// @throws std::invalid_argument  if the mesh is empty, an index is out of range, a
///                                coordinate not finite or above 1e75, a cell of no
///                                positive volume, or a facet labelled twice
template <int dim>
void require_valid(const SimplexMesh<dim>& mesh);

}  // namespace ffcontact
