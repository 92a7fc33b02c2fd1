// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/balance.hpp"

#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"
#include "ffcontact/elastic/row_sum.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/singular_values.hpp"
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// A motion is held by the stiffness when a row of K z is larger than this against |K|
/// |z|.
constexpr double motion_rounding = 1e-11;

/// K z of motions z, each row relative to its sum |K_ij|; 0 on prescribed dofs.
MatrixXd relative_forces(const ElasticSystem& system, const MatrixXd& motions) {
  MatrixXd forces = system.stiffness * motions;
  for (Index dof = 0; dof < forces.rows(); ++dof) {
    const double sum = row_sum(system.stiffness, dof);
    if (system.prescribed[dof] || sum == 0)
      forces.row(dof).setZero();
    else
      forces.row(dof) /= sum;
  }
  return forces;
}

}  // namespace

template <int dim>
MatrixXd unheld_motions(const SimplexMesh<dim>& mesh,
                        const ElasticSystem& system) {
  const MatrixXd motions = free_rigid_motions(mesh, system.prescribed);
  if (motions.cols() == 0) return motions;
  const SingularValues forces =
      singular_values(relative_forces(system, motions));
  const double least =
      motion_rounding * std::sqrt(static_cast<double>(motions.rows()));
  Index held = 0;
  while (held < motions.cols() && forces.values[held] > least) ++held;
  return product(motions, forces.V.rightCols(motions.cols() - held));
}

template MatrixXd unheld_motions(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                 const ElasticSystem&);

template <int dim>
double balance_defect(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                      const VectorXd& contact) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return 0;
  const VectorXd forces = system.load + contact;
  return relative(max_norm(VectorXd(motions.transpose() * forces)),
                  system.load.cwiseAbs().sum());
}

template double balance_defect(const SimplexMesh<FFCONTACT_DIMENSION>&,
                               const ElasticSystem&, const VectorXd&);

template <int dim>
void require_balance(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                     const ContactForcesOn& extreme,
                     const AlongNormals& along_n) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return;
  const VectorXd pushed = motions.transpose() * system.load;
  const double scale = system.load.cwiseAbs().sum();
  if (max_norm(pushed) <= unbalanced_loads * scale) return;

  const MatrixXd forces = extreme(motions);
  const VectorXd left =
      pushed + forces * nonnegative_least_squares(forces, -pushed);
  if (left.norm() <= unbalanced_loads * scale) return;
  const VectorXd motion = motions * (left / max_norm(left));
  refuse_unbalanced(
      mesh, unbalanced_motion(mesh, {motions, system.load, extreme, along_n},
                              motion));
}

template void require_balance(const SimplexMesh<FFCONTACT_DIMENSION>&,
                              const ElasticSystem&, const ContactForcesOn&,
                              const AlongNormals&);

}  // namespace ffcontact
