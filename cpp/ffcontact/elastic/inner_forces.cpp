// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/inner_forces.hpp"

#include "ffcontact/elastic/dofs.hpp"

namespace ffcontact {

template <int dim>
VectorXd inner_forces(
    const SimplexMesh<dim>& mesh,
    const Ref<const Matrix<double, voigt_size<dim>, Dynamic>>& stress) {
  VectorXd forces = VectorXd::Zero(dim * mesh.vertices.cols());
  for (int t = 0; t < mesh.cell_count(); ++t) {
    const auto gradients = hat_gradients(mesh, t);
    const double volume = signed_volume(mesh, t);
    for (int k = 0; k <= dim; ++k) {
      const VectorOf<dim> gradient = gradients.col(k);
      vector_at<dim>(forces, mesh.cells(k, t)) +=
          volume * traction(stress.col(t), gradient);
    }
  }
  return forces;
}

template VectorXd inner_forces<FFCONTACT_DIMENSION>(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const Ref<const Matrix<double, voigt_size<FFCONTACT_DIMENSION>, Dynamic>>&);

}  // namespace ffcontact
