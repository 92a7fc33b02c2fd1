// SPDX-License-Identifier: GPL-3.0-or-later
#include "freefem/views.hpp"

#include "ffcontact/base/require.hpp"

namespace ffcontact::plugin {

namespace {

void put_vertices(const Fem2D::Mesh& Th, Mesh& mesh) {
  mesh.vertices.resize(2, Th.nv);
  for (int v = 0; v < Th.nv; ++v) mesh.vertices.col(v) << Th(v).x, Th(v).y;
}

void put_triangles(const Fem2D::Mesh& Th, Mesh& mesh) {
  mesh.cells.resize(3, Th.nt);
  for (int t = 0; t < Th.nt; ++t)
    mesh.cells.col(t) << Th(t, 0), Th(t, 1), Th(t, 2);
}

void put_boundary(const Fem2D::Mesh& Th, Mesh& mesh) {
  mesh.boundary.resize(2, Th.neb);
  mesh.boundary_label.resize(Th.neb);
  for (int e = 0; e < Th.neb; ++e) {
    const Fem2D::Mesh::BorderElement& edge = Th.bedges[e];
    mesh.boundary.col(e) << Th(edge[0]), Th(edge[1]);
    mesh.boundary_label[e] = edge.lab;
  }
}

}  // namespace

Mesh mesh_of(const Fem2D::Mesh* fem_mesh) {
  if (!fem_mesh) refuse("the mesh is not set");
  Mesh mesh;
  put_vertices(*fem_mesh, mesh);
  put_triangles(*fem_mesh, mesh);
  put_boundary(*fem_mesh, mesh);
  require_valid(mesh);
  return mesh;
}

RowMatrix matrix_of(Matrice_Creuse<double>* matrix) {
  HashMatrix<int, double>* hash = matrix ? matrix->pHM() : nullptr;
  if (!hash) refuse("the matrix A is not set");
  int *rows, *columns;
  double* values;
  hash->CSR(rows, columns, values);
  const RowMatrix stored = Map<const RowMatrix>(
      hash->n, hash->m, static_cast<Index>(hash->nnz), rows, columns, values);
  if (!hash->half) return stored;
  RowMatrix transposed = stored.transpose();
  transposed.prune([](Index i, Index j, double) { return i != j; });
  return stored + transposed;
}

Map<VectorXd> vector_of(KN<double>* array) {
  return {static_cast<double*>(*array), array->N()};
}

}  // namespace ffcontact::plugin
