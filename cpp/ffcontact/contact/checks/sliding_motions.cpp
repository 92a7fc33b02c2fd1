// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_motions.hpp"

#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

constexpr double rounding_of_loads = 1e-13;

}  // namespace

template <int dim>
Matrix<double, dim*(dim + 1), Dynamic> lumped_loads(
    const SimplexMesh<dim>& mesh, const VectorXd& force) {
  Matrix<double, dim*(dim + 1), Dynamic> loads(dim * (dim + 1),
                                               mesh.cell_count());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      loads.col(t).template segment<dim>(dim * k) =
          signed_volume(mesh, t) / (dim + 1) *
          vector_at<dim>(force, mesh.cells(k, t));
  return loads;
}

template <int dim>
VectorXd sum_at_vertices(
    const SimplexMesh<dim>& mesh,
    const Matrix<double, dim*(dim + 1), Dynamic>& loads_of_cells) {
  VectorXd sum = VectorXd::Zero(mesh.vertices.size());
  for (int t = 0; t < mesh.cell_count(); ++t)
    for (int k = 0; k <= dim; ++k)
      vector_at<dim>(sum, mesh.cells(k, t)) +=
          loads_of_cells.col(t).template segment<dim>(dim * k);
  return sum;
}

template <int dim>
VectorXd lumped_coefficients(const SimplexMesh<dim>& mesh,
                             const MatrixXd& motions, const VectorXd& r) {
  const VectorXd mass =
      sum_at_vertices(mesh, lumped_loads(mesh, VectorXd::Ones(r.size())));
  const MatrixXd inertia =
      transposed_product(motions, mass.asDiagonal() * motions);
  return least_squares(inertia, motions.transpose() * r);
}

template <int dim>
VectorXd holding_force(const SimplexMesh<dim>& mesh, const MatrixXd& sliding,
                       const VectorXd& load) {
  if (sliding.cols() == 0) return {};
  if (max_norm(VectorXd(sliding.transpose() * load)) <=
      rounding_of_loads * load.cwiseAbs().sum())
    return {};
  return -sliding * lumped_coefficients(mesh, sliding, load);
}

template VectorXd lumped_coefficients(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                      const MatrixXd&, const VectorXd&);
template VectorXd holding_force(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                const MatrixXd&, const VectorXd&);
template Matrix<double, FFCONTACT_DIMENSION*(FFCONTACT_DIMENSION + 1), Dynamic>
lumped_loads(const SimplexMesh<FFCONTACT_DIMENSION>&, const VectorXd&);
template VectorXd sum_at_vertices(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const Matrix<double, FFCONTACT_DIMENSION*(FFCONTACT_DIMENSION + 1),
                 Dynamic>&);

}  // namespace ffcontact
