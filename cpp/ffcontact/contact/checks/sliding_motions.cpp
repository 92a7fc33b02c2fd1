// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_motions.hpp"

namespace ffcontact {

namespace {

constexpr double rounding_of_loads = 1e-13;

}  // namespace

template <int dim>
BodyLoadsOfCells<dim> holding_loads(const SimplexMesh<dim>& mesh,
                                    const MatrixXd& sliding,
                                    const VectorXd& load) {
  if (relative_push(load, sliding) <= rounding_of_loads)
    return BodyLoadsOfCells<dim>(dim * (dim + 1), 0);
  return lumped_loads(mesh, -sliding * lumped_coefficients(lumped_volumes(mesh),
                                                           sliding, load));
}

template BodyLoadsOfCells<FFCONTACT_DIMENSION> holding_loads(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const MatrixXd&, const VectorXd&);

}  // namespace ffcontact
