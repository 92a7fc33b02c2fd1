// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
#include "gmsh_program.hpp"
//
#include "guard.hpp"
#include "registration.hpp"
#include "views.hpp"

namespace ffcontact::plugin {

namespace {

/// FreeFEM's mesh; it belongs to the statement that asked for it.
pmesh fem_mesh_of(Stack stack, const GmshMesh& gmsh) {
  const Mesh& mesh = gmsh.mesh;
  const int nv = mesh.vertex_count(), nt = mesh.triangle_count(), neb = static_cast<int>(mesh.boundary.cols());
  auto* vertices = new Fem2D::Vertex[nv];
  auto* triangles = new Fem2D::Triangle[nt];
  auto* boundary = new Fem2D::BoundaryEdge[neb];
  for (int v = 0; v < nv; ++v) {
    vertices[v].x = mesh.vertices(0, v);
    vertices[v].y = mesh.vertices(1, v);
  }
  for (int t = 0; t < nt; ++t)
    triangles[t].set(vertices, mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t), gmsh.regions[t]);
  for (int e = 0; e < neb; ++e) {
    boundary[e] = Fem2D::BoundaryEdge(vertices, mesh.boundary(0, e), mesh.boundary(1, e), mesh.boundary_label[e]);
    for (int end = 0; end < 2; ++end) {
      Fem2D::Vertex& vertex = vertices[mesh.boundary(end, e)];
      if (vertex.lab == 0) vertex.lab = mesh.boundary_label[e];
    }
  }
  auto* fem_mesh = new Fem2D::Mesh(nv, nt, neb, vertices, triangles, boundary);
  R2 lowest, highest;
  fem_mesh->BoundingBox(lowest, highest);
  fem_mesh->quadtree = new Fem2D::FQuadTree(fem_mesh, lowest, highest, nv);
  return Add2StackOfPtr2FreeRC(stack, fem_mesh);
}

void report(const string& file, const GmshMesh& gmsh) {
  if (verbosity > 0 && mpirank == 0)
    cout << "gmshmesh: " << file << ", " << gmsh.mesh.triangle_count() << " triangles, " << gmsh.mesh.vertex_count()
         << " vertices" << endl;
}

/// Th = gmshmesh("part.geo"), or gmshmesh("part.msh")
pmesh gmshmesh(Stack stack, string* const& file) {
  return GetAny<pmesh>(guarded("gmshmesh", [&] {
    const GmshMesh gmsh = gmsh_mesh(*file);
    report(*file, gmsh);
    return SetAny<pmesh>(fem_mesh_of(stack, gmsh));
  }));
}

/// Th = gmshmesh("part.geo", Th, size): edges of the lengths `size`, one value a vertex of Th
pmesh gmshmesh_sized(Stack stack, string* const& geometry, pmesh const& background, KN<double>* const& size) {
  return GetAny<pmesh>(guarded("gmshmesh", [&] {
    const GmshMesh gmsh = gmsh_mesh(*geometry, mesh_of(background), vector_of(size));
    report(*geometry, gmsh);
    return SetAny<pmesh>(fem_mesh_of(stack, gmsh));
  }));
}

/// label = gmshlabel("part.geo", "contact")
long gmshlabel(Stack, string* const& file, string* const& name) {
  return GetAny<long>(guarded("gmshlabel", [&] { return SetAny<long>(gmsh_label(*file, *name)); }));
}

}  // namespace

void register_gmsh_functions() {
  Global.Add("gmshmesh", "(", new OneOperator1s_<pmesh, string*>(gmshmesh));
  Global.Add("gmshmesh", "(", new OneOperator3s_<pmesh, string*, pmesh, KN<double>*>(gmshmesh_sized));
  Global.Add("gmshlabel", "(", new OneOperator2s_<long, string*, string*>(gmshlabel));
}

}  // namespace ffcontact::plugin
