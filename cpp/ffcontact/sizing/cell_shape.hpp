// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// Volume of the regular simplex whose edges are 1 long: the equilateral triangle has
/// 3^(1/2)/4, the regular tetrahedron 2^(1/2)/12.
template <int dim>
double regular_volume();

/// Edge length of the regular simplex of a volume [mm].
template <int dim>
double size_of_volume(double volume);

/// That of a cell's volume [mm].
template <int dim>
double size_of_cell(const SimplexMesh<dim>& mesh, int cell);

/// Root of the mean of the squared edges of each cell [mm]: the error of a linear element
/// of a given volume goes with it.
template <int dim>
VectorXd mean_edges(const SimplexMesh<dim>& mesh);

/// Shapes per cell: s / l, where s is the size of the cell and l its mean edge, 1 for a regular simplex and less for all others:
///     (4 sqrt(3) |E| / sum of l^2)^(1/2),   in space   (6 (72 |E|^2)^(1/3) / sum of l^2)^(1/2).
/// 0.93 for half a square, 0.87 for a sixth of a cube, 0.9 to 0.92 in the mean of the
/// tetrahedra that gmsh makes.
template <int dim>
VectorXd shape_quality(const SimplexMesh<dim>& mesh);

}  // namespace ffcontact
