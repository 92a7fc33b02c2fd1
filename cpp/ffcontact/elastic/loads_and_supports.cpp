// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/loads_and_supports.hpp"

#include <vector>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

constexpr double tgv = 1e30;  // FreeFEM's

/// The columns of SimplexMesh::boundary that have a label.
template <int dim>
std::vector<Index> columns_of(const SimplexMesh<dim>& mesh, int label) {
  std::vector<Index> columns;
  for (Index f = 0; f < mesh.boundary.cols(); ++f)
    if (mesh.boundary_label[f] == label) columns.push_back(f);
  if (columns.empty())
    refuse("label ", label, " is on no boundary ", MeshWords<dim>::facet,
           " of the mesh");
  return columns;
}

}  // namespace

template <int dim>
void add_traction(const SimplexMesh<dim>& mesh, int label,
                  const VectorOf<dim>& traction, VectorXd& b,
                  Matrix<double, dim * dim, Dynamic>& moments) {
  require_size("b", b.size(), dim * mesh.vertices.cols());
  require_size("moments", moments.cols(), mesh.boundary.cols());
  for (const Index f : columns_of(mesh, label)) {
    const VectorOf<dim> share = boundary_measure(mesh, f) / dim * traction;
    moments.col(f) += share.template replicate<dim, 1>();
    for (const int v : mesh.boundary.col(f)) vector_at<dim>(b, v) += share;
  }
}

template <int dim>
void prescribe(const SimplexMesh<dim>& mesh, int label, int component,
               double value, RowMatrix& A, VectorXd& b) {
  require_size("A", A.rows(), dim * mesh.vertices.cols());
  require_size("b", b.size(), A.rows());
  if (component < 0 || component >= dim)
    refuse("displacements have the components 0 to ", dim - 1, ", got ",
           component);
  for (const Index f : columns_of(mesh, label))
    for (const int v : mesh.boundary.col(f)) {
      const int dof = dof_of<dim>(v, component);
      A.coeffRef(dof, dof) = tgv;
      b[dof] = tgv * value;
    }
}

template void add_traction(const Mesh&, int, const Vector2d&, VectorXd&,
                           Matrix4Xd&);
template void add_traction(const SolidMesh&, int, const Vector3d&, VectorXd&,
                           Matrix<double, 9, Dynamic>&);
template void prescribe(const Mesh&, int, int, double, RowMatrix&, VectorXd&);
template void prescribe(const SolidMesh&, int, int, double, RowMatrix&,
                        VectorXd&);

}  // namespace ffcontact
