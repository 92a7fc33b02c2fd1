// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/row_matrix.hpp"
#include "ffcontact/mesh/mesh.hpp"

/// What FreeFEM's int1d, int2d and on() add to A and b, for programs without FreeFEM.
namespace ffcontact {

/// Adds a traction [MPa] that is constant on the facets of a label to the loads b and to
/// the moments of the given tractions.
/// @param b        on all dofs [N; per unit thickness in the plane]
/// @param moments  int F phi at the vertices of each column of SimplexMesh::boundary, one
///                 below the other [dim^2 x boundary]
/// @throws std::invalid_argument  if sizes do not fit, or the label is on no facet
template <int dim>
void add_traction(const SimplexMesh<dim>& mesh, int label,
                  const VectorOf<dim>& traction, VectorXd& b,
                  Matrix<double, dim * dim, Dynamic>& moments);

/// Prescribes a component of the displacement [mm] at the vertices of a label's facets:
/// 1e30 on the diagonal of A, 1e30 times the value in b.
/// @throws std::invalid_argument  likewise, or if there is no such component
template <int dim>
void prescribe(const SimplexMesh<dim>& mesh, int label, int component,
               double value, RowMatrix& A, VectorXd& b);

}  // namespace ffcontact
