// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/mesh/mesh.hpp"

namespace ffcontact {

/// The body that each vertex belongs to, numbered from 0 on: vertices of one cell are of
/// one body.
template <int dim>
std::vector<int> body_of_each_vertex(const SimplexMesh<dim>& mesh);

/// A body that shares no vertex with the other bodies of its mesh; vertices of two bodies
/// may lie at one place.
struct SeparateBody {
  Mesh mesh;
  std::vector<int> vertex, cell;  ///< in the whole mesh, ascending
};

/// The bodies of a mesh, in the order of their lowest vertices. Vertices of no triangle
/// are left out.
std::vector<SeparateBody> separate_bodies(const Mesh& mesh);

}  // namespace ffcontact
