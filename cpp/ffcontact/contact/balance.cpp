// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/balance.hpp"

#include <cmath>

#include "ffcontact/base/nonnegative_least_squares.hpp"
#include "ffcontact/base/norms.hpp"
#include "ffcontact/base/products.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/base/singular_values.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

namespace {

constexpr double unbalanced = 1e-9;
/// A motion is held by the stiffness when a row of K z is larger than this against |K|
/// |z|.
constexpr double motion_rounding = 1e-11;

/// Work along each motion of multipliers that span the cones, one column per multiplier
/// [motions x multipliers]. Those of Coulomb's law are of size 1 whatever mu is, and -n is
/// one of them: of two that are nearly +t and -t it would be the rounding.
MatrixXd extreme_forces(const ContactLine& line, const ContactLaw& law,
                        const MatrixXd& motions) {
  const MatrixXd weighted =
      weight_of_rows(law.multiplier, line) * traces_of(line, motions);
  MatrixXd work(motions.cols(), 3 * line.node_count());
  Index next = 0;
  for (int i = 0; i < line.node_count(); ++i) {
    const VectorXd n = weighted.row(2 * i), t = weighted.row(2 * i + 1);
    if (law.tresca()) {
      const double can_hold = law.slip_bound[i] > 0 ? 1 : 0;
      work.col(next++) = -n;
      work.col(next++) = can_hold * t;
      work.col(next++) = -can_hold * t;
    } else {
      const double mu = law.friction[i], size = std::hypot(1, mu);
      work.col(next++) = -n;
      work.col(next++) = (mu / size) * t - n / size;
      work.col(next++) = -(mu / size) * t - n / size;
    }
  }
  return work;
}

double row_sum(const RowMatrix& K, Index row) {
  double sum = 0;
  for (RowMatrix::InnerIterator entry(K, row); entry; ++entry)
    sum += std::abs(entry.value());
  return sum;
}

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

template MatrixXd unheld_motions(const Mesh&, const ElasticSystem&);
template MatrixXd unheld_motions(const SolidMesh&, const ElasticSystem&);

template <int dim>
double balance_defect(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                      const VectorXd& contact) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return 0;
  const VectorXd forces = system.load + contact;
  return relative(max_norm(VectorXd(motions.transpose() * forces)),
                  system.load.cwiseAbs().sum());
}

template double balance_defect(const Mesh&, const ElasticSystem&,
                               const VectorXd&);
template double balance_defect(const SolidMesh&, const ElasticSystem&,
                               const VectorXd&);

template <int dim>
void require_balance(const SimplexMesh<dim>& mesh, const ElasticSystem& system,
                     const ContactForcesOn& extreme,
                     const AlongNormals& along_n) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return;
  const VectorXd pushed = motions.transpose() * system.load;
  const double scale = system.load.cwiseAbs().sum();
  if (max_norm(pushed) <= unbalanced * scale) return;

  const MatrixXd forces = extreme(motions);
  const VectorXd left =
      pushed + forces * nonnegative_least_squares(forces, -pushed);
  if (left.norm() <= unbalanced * scale) return;
  refuse_unbalanced(
      mesh, unbalanced_motion(mesh, {motions, system.load, extreme, along_n},
                              motions * (left / max_norm(left))));
}

template void require_balance(const Mesh&, const ElasticSystem&,
                              const ContactForcesOn&, const AlongNormals&);
template void require_balance(const SolidMesh&, const ElasticSystem&,
                              const ContactForcesOn&, const AlongNormals&);

void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw& law, const ElasticSystem& system) {
  require_balance(
      mesh, system,
      [&](const MatrixXd& motions) {
        return extreme_forces(line, law, motions);
      },
      along_normals(line));
}

void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw& law, const ElasticSystem& system,
                     const MatrixXd& motions, const VectorXd& push) {
  const MatrixXd unheld = unheld_motions(mesh, system);
  MatrixXd all(motions.rows(), unheld.cols() + motions.cols());
  all << unheld, motions;
  VectorXd pushed(all.cols());
  pushed << unheld.transpose() * system.load, -push;
  const double scale = system.load.cwiseAbs().sum() + push.cwiseAbs().sum();
  const MatrixXd forces = extreme_forces(line, law, all);
  const VectorXd left =
      pushed + forces * nonnegative_least_squares(forces, -pushed);
  if (left.norm() > unbalanced * scale)
    refuse(
        "no contact forces in the cone have the force and the moment of push= "
        "and moment=, or they push the body where nothing holds it: the tool "
        "is drawn away, slides, or tips over an end of the contact line");
}

}  // namespace ffcontact
