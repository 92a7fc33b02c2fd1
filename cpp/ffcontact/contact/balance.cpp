// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/balance.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "ffcontact/base/nonnegative_least_squares.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

namespace {

constexpr double unbalanced = 1e-9;
/// A motion is held by the stiffness when a row of K z is larger than this against |K|
/// |z|.
constexpr double rounding = 1e-11;

/// Work of the extreme contact multipliers along each motion, one column per multiplier
/// [motions x multipliers].
MatrixXd extreme_forces(const ContactLine& line, const ContactLaw& law,
                        const MatrixXd& motions) {
  MatrixXd trace(2 * line.node_count(), motions.cols());
  for (Index k = 0; k < motions.cols(); ++k)
    trace.col(k) = contact_components(line, motions.col(k)).reshaped();
  const MatrixXd weighted = weight_of_rows(law.multiplier, line) * trace;

  MatrixXd work(motions.cols(), (law.tresca() ? 3 : 2) * line.node_count());
  Index next = 0;
  for (int i = 0; i < line.node_count(); ++i) {
    const VectorXd n = weighted.row(2 * i), t = weighted.row(2 * i + 1);
    if (law.tresca()) {
      const double can_hold = law.slip_bound[i] > 0 ? 1 : 0;
      work.col(next++) = -n;
      work.col(next++) = can_hold * t;
      work.col(next++) = -can_hold * t;
    } else {
      work.col(next++) = -n + law.friction[i] * t;
      work.col(next++) = -n - law.friction[i] * t;
    }
  }
  return work;
}

}  // namespace

MatrixXd unheld_motions(const Mesh& mesh, const ElasticSystem& system) {
  const MatrixXd motions = free_rigid_motions(mesh, system.prescribed);
  if (motions.cols() == 0) return motions;
  MatrixXd forces = system.stiffness * motions;
  for (Index dof = 0; dof < forces.rows(); ++dof) {
    double row_sum = 0;
    for (RowMatrix::InnerIterator entry(system.stiffness, dof); entry; ++entry)
      row_sum += std::abs(entry.value());
    if (system.prescribed[dof] || row_sum == 0)
      forces.row(dof).setZero();
    else
      forces.row(dof) /= row_sum;
  }
  // descending
  const Eigen::JacobiSVD<MatrixXd> svd(
      forces, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Index held = 0;
  while (held < motions.cols() &&
         svd.singularValues()[held] >
             rounding * std::sqrt(static_cast<double>(forces.rows())))
    ++held;
  return motions * svd.matrixV().rightCols(motions.cols() - held);
}

void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw& law, const ElasticSystem& system) {
  const MatrixXd motions = unheld_motions(mesh, system);
  if (motions.cols() == 0) return;
  const VectorXd pushed = motions.transpose() * system.load;
  const double scale = system.load.cwiseAbs().sum();
  if (pushed.cwiseAbs().maxCoeff() <= unbalanced * scale) return;

  const MatrixXd forces = extreme_forces(line, law, motions);
  const VectorXd left =
      pushed + forces * nonnegative_least_squares(forces, -pushed);
  if (left.norm() > unbalanced * scale)
    refuse(
        "no equilibrium: the loads push the body in a ",
        motion_in_words(mesh, motions * left),
        ", which neither prescribed displacements nor contact forces oppose");
}

}  // namespace ffcontact
