// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/require.hpp"
#include "ffcontact/mesh/mesh.hpp"
//
#include "freefem/held_mesh.hpp"

/// FreeFEM's meshes as the core's.
namespace ffcontact::plugin {

template <int d>
void put_vertices(const FemMesh<d>& Th, SimplexMesh<d>& mesh) {
  mesh.vertices.resize(d, Th.nv);
  for (int v = 0; v < Th.nv; ++v)
    for (int c = 0; c < d; ++c) mesh.vertices(c, v) = Th(v)[c];
}

template <int d>
void put_cells(const FemMesh<d>& Th, SimplexMesh<d>& mesh) {
  mesh.cells.resize(d + 1, Th.nt);
  for (int t = 0; t < Th.nt; ++t)
    for (int k = 0; k <= d; ++k) mesh.cells(k, t) = Th(t, k);
}

template <int d>
void put_boundary(const FemMesh<d>& Th, SimplexMesh<d>& mesh) {
  mesh.boundary.resize(d, Th.nbBrdElmts());
  mesh.boundary_label.resize(Th.nbBrdElmts());
  for (int e = 0; e < Th.nbBrdElmts(); ++e) {
    const auto& facet = Th.be(e);
    for (int k = 0; k < d; ++k) mesh.boundary(k, e) = Th(facet[k]);
    mesh.boundary_label[e] = facet.lab;
  }
}

/// Column e of SimplexMesh::boundary is FreeFEM's boundary element e.
template <int d>
SimplexMesh<d> read_mesh(const FemMesh<d>& Th) {
  SimplexMesh<d> mesh;
  put_vertices<d>(Th, mesh);
  put_cells<d>(Th, mesh);
  put_boundary<d>(Th, mesh);
  require_valid(mesh);
  return mesh;
}

/// @throws std::invalid_argument  if the mesh was never assigned
inline Mesh mesh_of(pmesh fem_mesh) {
  if (!fem_mesh) refuse("the mesh is not set");
  return read_mesh<2>(*fem_mesh);
}
inline SolidMesh mesh_of(pmesh3 fem_mesh) {
  if (!fem_mesh) refuse("the mesh3 is not set");
  return read_mesh<3>(*fem_mesh);
}

}  // namespace ffcontact::plugin
