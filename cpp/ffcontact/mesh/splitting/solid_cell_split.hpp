// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// Tetrahedra of one cell.
struct SolidCellSplit {
  /// corners of the cell, in an order of positive volume; the number of its corners
  /// stands for its middle. None where the cell is flat or folded.
  std::vector<Vector4i> tetrahedra;
  bool has_middle = false;  ///< a new vertex, the mean of the corners
};

/// Splits a pyramid, a prism or a hexahedron into tetrahedra.
///
/// Each quadrangle of the surface is cut as quadrangle_triangles says, which depends on
/// the quadrangle alone: neighbours agree whatever they are. What is inside is then free:
///  1. where the diagonals of all quadrangles at one corner meet in it, the tetrahedra
///     join it to the other triangles of the surface: 2, 3 and 6 of them;
///  2. a hexahedron with parallel diagonals on two opposite quadrangles is two prisms;
///  3. otherwise they join a new vertex in the middle to all triangles of the surface.
/// Of several ways of a step that is taken whose smallest tetrahedron is the largest.
///
/// Diagonals through the lowest numbers meet in the lowest corner, so that step 1 is
/// always enough [Dompierre, Labbe, Vallet, Camarero: How to subdivide pyramids, prisms
/// and hexahedra into tetrahedra, 8th International Meshing Roundtable, 1999]. That rule
/// holds here where diagonals are equal, as on all bricks. Shortest diagonals give rounder
/// tetrahedra of skewed cells, but may leave no way without a new vertex: 2 of the 8
/// patterns of a prism (Schoenhardt's), 18 of the 64 of a hexahedron. Of its other 46, 42
/// have a corner where three diagonals meet, and 4, those of cells skewed alike in three
/// directions, are two prisms. That no other pattern has a way was found by listing the
/// 74 triangulations of a cube. Where vertices of bricks are moved at random, by however
/// little, 12 % of hexahedra and 7 % of prisms have a new vertex.
/// @param corners  5, 6 or 8 columns, as gmsh orders them, or their mirror image
/// @param numbers  of the vertices in the mesh, different
SolidCellSplit solid_cell_split(const Matrix3Xd& corners,
                                const VectorXi& numbers);

}  // namespace ffcontact
