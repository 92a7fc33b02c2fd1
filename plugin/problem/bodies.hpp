// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/facets.hpp"
#include "ffcontact/mesh/joined_mesh.hpp"
//
#include "freefem/body_part.hpp"
#include "freefem/read_mesh.hpp"
#include "problem/body_dofs.hpp"

namespace ffcontact::plugin {

/// The meshes of one plane body or several, or of solids, as one.
template <int d>
struct Bodies : BodyDofs {
  JoinedBodies<d> joined;
  Facets<d> facets;
  /// none where other processes hold parts of them
  std::vector<HeldMesh<d>> fem_meshes;

  /// @throws std::invalid_argument  if a mesh is not usable
  explicit Bodies(const FemMeshes<d>& meshes) : Bodies(joined_mesh_of(meshes)) {
    fem_meshes = {meshes.begin(), meshes.end()};
  }
  explicit Bodies(JoinedBodies<d> whole)
      : BodyDofs(d, whole.first_vertex),
        joined(std::move(whole)),
        facets(facets_of(joined.mesh)) {}

  BodyPart<d> part(int body,
                   const PlacesElsewhere<d>* elsewhere = nullptr) const {
    return {joined.mesh,
            facets,
            elsewhere ? nullptr : &*fem_meshes[body],
            body,
            joined.first_cell[body],
            joined.first_boundary[body],
            elsewhere};
  }

 private:
  static JoinedBodies<d> joined_mesh_of(const FemMeshes<d>& fem_meshes) {
    std::vector<SimplexMesh<d>> meshes;
    meshes.reserve(fem_meshes.size());
    for (const FemMesh<d>* fem_mesh : fem_meshes) {
      if (std::count(fem_meshes.begin(), fem_meshes.end(), fem_mesh) > 1)
        refuse(
            "two bodies have one mesh, and would move apart from each other: "
            "cut a body that touches itself in two, which bonded=true joins");
      meshes.push_back(mesh_of(fem_mesh));
    }
    return joined_mesh(meshes);
  }
};

}  // namespace ffcontact::plugin
