// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/elastic/row_matrix.hpp"
#include "ffcontact/mesh/mesh.hpp"
//
#include "freefem/freefem.hpp"

/// FreeFEM's data as the core's.
namespace ffcontact::plugin {

/// FreeFEM's mesh; column e of Mesh::boundary is FreeFEM's boundary element e.
/// @throws std::invalid_argument  if the mesh was never assigned
Mesh mesh_of(const Fem2D::Mesh* mesh);

/// FreeFEM's matrix by rows. A matrix that stores one triangle only (sym=1) is completed.
/// @throws std::invalid_argument  if the matrix was never assigned
RowMatrix matrix_of(Matrice_Creuse<double>* matrix);

Map<VectorXd> vector_of(KN<double>* array);

}  // namespace ffcontact::plugin
