// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/new_mesh.hpp"

namespace ffcontact::plugin {

namespace {

/// FreeFEM's mesh owns what is made here.
Fem2D::Vertex* new_vertices(const Mesh& mesh) {
  auto* vertices = new Fem2D::Vertex[mesh.vertex_count()];
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    vertices[v].x = mesh.vertices(0, v);
    vertices[v].y = mesh.vertices(1, v);
  }
  return vertices;
}

Fem2D::Vertex3* new_vertices(const SolidMesh& mesh) {
  auto* vertices = new Fem2D::Vertex3[mesh.vertex_count()];
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    vertices[v].x = mesh.vertices(0, v);
    vertices[v].y = mesh.vertices(1, v);
    vertices[v].z = mesh.vertices(2, v);
    vertices[v].lab = 0;
  }
  return vertices;
}

/// A vertex has the label of the first part of the boundary that it is on.
template <int dim, class Vertices>
void put_labels(const SimplexMesh<dim>& mesh, Vertices* vertices) {
  for (Index e = 0; e < mesh.boundary.cols(); ++e)
    for (const int v : mesh.boundary.col(e))
      if (vertices[v].lab == 0) vertices[v].lab = mesh.boundary_label[e];
}

}  // namespace

pmesh fem_mesh_of(Stack stack, const Mesh& mesh, const VectorXi& regions) {
  const int nv = mesh.vertex_count(), nt = mesh.cell_count(),
            neb = static_cast<int>(mesh.boundary.cols());
  Fem2D::Vertex* vertices = new_vertices(mesh);
  auto* triangles = new Fem2D::Triangle[nt];
  auto* boundary = new Fem2D::BoundaryEdge[neb];
  for (int t = 0; t < nt; ++t)
    triangles[t].set(vertices, mesh.cells(0, t), mesh.cells(1, t),
                     mesh.cells(2, t), regions[t]);
  for (int e = 0; e < neb; ++e)
    boundary[e] =
        Fem2D::BoundaryEdge(vertices, mesh.boundary(0, e), mesh.boundary(1, e),
                            mesh.boundary_label[e]);
  put_labels(mesh, vertices);
  auto* fem_mesh = new Fem2D::Mesh(nv, nt, neb, vertices, triangles, boundary);
  R2 lowest, highest;
  fem_mesh->BoundingBox(lowest, highest);
  fem_mesh->quadtree = new Fem2D::FQuadTree(fem_mesh, lowest, highest, nv);
  return Add2StackOfPtr2FreeRC(stack, fem_mesh);
}

pmesh3 fem_mesh_of(Stack stack, const SolidMesh& mesh,
                   const VectorXi& regions) {
  const int nv = mesh.vertex_count(), nt = mesh.cell_count(),
            neb = static_cast<int>(mesh.boundary.cols());
  Fem2D::Vertex3* vertices = new_vertices(mesh);
  auto* tetrahedra = new Fem2D::Tet[nt];
  auto* boundary = new Fem2D::Triangle3[neb];
  for (int t = 0; t < nt; ++t) {
    Vector4i corners = mesh.cells.col(t);
    tetrahedra[t].set(vertices, corners.data(), regions[t]);
  }
  for (int e = 0; e < neb; ++e) {
    Vector3i corners = mesh.boundary.col(e);
    boundary[e].set(vertices, corners.data(), mesh.boundary_label[e]);
  }
  put_labels(mesh, vertices);
  auto* fem_mesh =
      new Fem2D::Mesh3(nv, nt, neb, vertices, tetrahedra, boundary);
  fem_mesh->BuildGTree();
  return Add2StackOfPtr2FreeRC(stack, fem_mesh);
}

}  // namespace ffcontact::plugin
