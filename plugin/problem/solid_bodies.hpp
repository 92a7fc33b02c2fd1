// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "freefem/held_mesh.hpp"
#include "freefem/solid_views.hpp"
#include "problem/body_dofs.hpp"

namespace ffcontact::plugin {

/// The meshes of one solid or several, as one.
struct SolidBodies : BodyDofs {
  JoinedSolids joined;
  Facets<3> faces;
  /// none where other processes hold parts of them
  std::vector<HeldMesh<Fem2D::Mesh3>> fem_meshes;

  /// @throws std::invalid_argument  if a mesh is not usable
  explicit SolidBodies(const std::vector<pmesh3>& meshes)
      : SolidBodies(joined_solids(meshes)) {
    fem_meshes = {meshes.begin(), meshes.end()};
  }
  explicit SolidBodies(JoinedSolids whole)
      : BodyDofs(3, whole.first_vertex),
        joined(std::move(whole)),
        faces(facets_of(joined.mesh)) {}

  SolidPart part(int body,
                 const PlacesElsewhere<3>* elsewhere = nullptr) const {
    return {joined.mesh,
            faces,
            elsewhere ? nullptr : &*fem_meshes[body],
            body,
            joined.first_cell[body],
            joined.first_boundary[body],
            elsewhere};
  }

 private:
  static JoinedSolids joined_solids(const std::vector<pmesh3>& fem_meshes) {
    std::vector<SolidMesh> meshes;
    meshes.reserve(fem_meshes.size());
    for (pmesh3 fem_mesh : fem_meshes)
      meshes.push_back(solid_mesh_of(fem_mesh));
    return joined_mesh(meshes);
  }
};

}  // namespace ffcontact::plugin
