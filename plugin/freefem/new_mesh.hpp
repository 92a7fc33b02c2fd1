// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"
//
#include "freefem/freefem.hpp"

namespace ffcontact::plugin {

/// FreeFEM's mesh; it belongs to the statement that asked for it.
/// @param regions  one per triangle
pmesh fem_mesh_of(Stack stack, const Mesh& mesh, const VectorXi& regions);

/// FreeFEM's mesh3, likewise.
/// @param regions  one per tetrahedron
pmesh3 fem_mesh_of(Stack stack, const SolidMesh& mesh, const VectorXi& regions);

}  // namespace ffcontact::plugin
