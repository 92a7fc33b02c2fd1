// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact::plugin {

struct Solid {
  SolidMesh mesh;
  VectorXi regions;  ///< one per tetrahedron
};

/// A solid meshed anew by gmsh with edges of the lengths `size` [mm] at its vertices, on
/// the geometry that surface_model finds in its mesh: labels, regions, planes, edges
/// between surfaces and corners are kept, vertices of smooth surfaces and curves put on
/// them.
/// @param corner  angle at which surfaces have edges and curves corners [rad]
/// @throws std::invalid_argument  if a size is not positive, gmsh is missing, or cannot
///                                mesh the body
Solid remeshed(Solid solid, const Ref<const VectorXd>& size, double corner);

}  // namespace ffcontact::plugin
