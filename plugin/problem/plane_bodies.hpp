// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "freefem/held_mesh.hpp"
#include "freefem/plane_part.hpp"
#include "freefem/views.hpp"
#include "problem/body_dofs.hpp"

namespace ffcontact::plugin {

/// The meshes of one plane body or several, as one.
struct PlaneBodies : BodyDofs {
  JoinedMesh joined;
  /// none where other processes hold parts of them
  std::vector<HeldMesh<Fem2D::Mesh>> fem_meshes;

  /// @throws std::invalid_argument  if a mesh is not usable
  explicit PlaneBodies(const std::vector<pmesh>& meshes)
      : PlaneBodies(joined_meshes(meshes)) {
    fem_meshes = {meshes.begin(), meshes.end()};
  }
  explicit PlaneBodies(JoinedMesh whole)
      : BodyDofs(2, whole.first_vertex), joined(std::move(whole)) {}

  BodyPart part(int body, const PlacesElsewhere<2>* elsewhere = nullptr) const {
    return {joined.mesh,
            elsewhere ? nullptr : &*fem_meshes[body],
            body,
            joined.first_cell[body],
            joined.first_boundary[body],
            elsewhere};
  }

 private:
  static JoinedMesh joined_meshes(const std::vector<pmesh>& fem_meshes) {
    std::vector<Mesh> meshes;
    meshes.reserve(fem_meshes.size());
    for (pmesh fem_mesh : fem_meshes) meshes.push_back(mesh_of(fem_mesh));
    return joined_mesh(meshes);
  }
};

}  // namespace ffcontact::plugin
