// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/mesh/remeshing/patch_curves.hpp"

namespace ffcontact {

/// The geometry of a solid as its mesh tells it: parts of the body, patches of planes and
/// smooth surfaces around them, the curves in which these meet, and corners. A remesher
/// that keeps it keeps labels, regions, edges between labels and corners.
struct SurfaceModel {
  DividingFaces dividing;
  SurfacePatches patches;
  PatchCurves curves;
};

/// @param corner  angle at which surfaces have edges and curves have corners [rad]
/// @throws std::invalid_argument  as facets_of and dividing_faces
inline SurfaceModel surface_model(const SolidMesh& mesh, const Facets<3>& faces,
                                  const VectorXi& regions, double corner) {
  SurfaceModel model;
  model.dividing = dividing_faces(mesh, faces, regions);
  const std::vector<DividingEdge> edges = dividing_edges(faces, model.dividing);
  model.patches = surface_patches(mesh, faces, model.dividing, edges, corner);
  model.curves = patch_curves(mesh, edges, model.patches, corner);
  return model;
}

}  // namespace ffcontact
