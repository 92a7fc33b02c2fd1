// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/remeshing/surface_model.hpp"

namespace ffcontact {

/// A mesh that a remesher made of a SurfaceModel: column e of SolidMesh::boundary is a
/// face of patch[e].
struct ModelMesh {
  SolidMesh mesh;
  std::vector<int> part;   ///< of each tetrahedron
  std::vector<int> patch;  ///< of each boundary face
  Matrix2Xi lines;         ///< vertices of the edges on curves
  std::vector<int> curve;  ///< of each line
};

/// The vertices of `fine`, which are on the faces of `mesh`, moved onto the smooth
/// surfaces and curves that these are facets and chords of: cubic triangles through the
/// vertices of `mesh` and their mean normals, cubics through four vertices of a curve.
/// Surfaces go on beyond a line at which nothing but their label changes, which stays on them
/// however it turns. Planes, straight lines and corners stay. Vertices whose tetrahedra
/// would lose more than half of their volume move less, or not at all.
SolidMesh moved_onto_surfaces(const ModelMesh& fine, const SolidMesh& mesh,
                              const Facets<3>& faces,
                              const SurfaceModel& model);

}  // namespace ffcontact
