// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_motions.hpp"

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

namespace {

constexpr double rounding_of_loads = 1e-13;

}  // namespace

template <int dim>
LoadsOfCells<dim> lumped_loads(const SimplexMesh<dim>& mesh,
                               const VectorXd& force) {
  LoadsOfCells<dim> loads(dim * (dim + 1), mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      loads.col(t).template segment<dim>(dim * k) =
          signed_volume(mesh, t) / (dim + 1) *
          vector_at<dim>(force, mesh.cells(k, t));
  return loads;
}

template <int dim>
VectorXd sum_at_vertices(const SimplexMesh<dim>& mesh,
                         const LoadsOfCells<dim>& loads) {
  VectorXd sum = VectorXd::Zero(mesh.vertices.size());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      vector_at<dim>(sum, mesh.cells(k, t)) +=
          loads.col(t).template segment<dim>(dim * k);
  return sum;
}

template <int dim>
LoadsOfCells<dim> holding_loads(const SimplexMesh<dim>& mesh,
                                const MatrixXd& sliding, const VectorXd& load) {
  if (relative_push(load, sliding) <= rounding_of_loads)
    return LoadsOfCells<dim>::Zero(dim * (dim + 1), mesh.cell_count());
  return lumped_loads(mesh, -sliding * lumped_coefficients(lumped_volumes(mesh),
                                                           sliding, load));
}

template LoadsOfCells<FFCONTACT_DIMENSION> lumped_loads(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const VectorXd&);
template VectorXd sum_at_vertices(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                  const LoadsOfCells<FFCONTACT_DIMENSION>&);
template LoadsOfCells<FFCONTACT_DIMENSION> holding_loads(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const MatrixXd&, const VectorXd&);

}  // namespace ffcontact
