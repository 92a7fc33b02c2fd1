// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/balance.hpp"

#include "ffcontact/base/nonnegative_least_squares.hpp"
#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/rigid_motions.hpp"

namespace ffcontact {

namespace {

constexpr double unbalanced = 1e-9;

/// Work of the extreme contact forces along each motion, one column per force [motions x forces].
Eigen::MatrixXd extreme_forces(const ContactLine& line, const ContactLaw& law, const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd work(motions.cols(), (law.tresca() ? 3 : 2) * line.node_count());
  Eigen::Index next = 0;
  for (int i = 0; i < line.node_count(); ++i) {
    const Eigen::MatrixXd z = motions.middleRows(2 * line.vertex[i], 2);
    const Eigen::Vector2d n = line.normal.col(i), t = line.tangent(i);
    if (law.tresca()) {
      const double can_hold = law.slip_bound[i] > 0 ? 1 : 0;
      work.col(next++) = -z.transpose() * n;
      work.col(next++) = can_hold * z.transpose() * t;
      work.col(next++) = -can_hold * z.transpose() * t;
    } else {
      work.col(next++) = z.transpose() * (-n + law.friction[i] * t);
      work.col(next++) = z.transpose() * (-n - law.friction[i] * t);
    }
  }
  return work;
}

}  // namespace

void require_balance(const Mesh& mesh, const ContactLine& line, const ContactLaw& law, const ElasticSystem& system) {
  const Eigen::MatrixXd motions = free_rigid_motions(mesh, system.prescribed);
  if (motions.cols() == 0) return;
  const Eigen::VectorXd pushed = motions.transpose() * system.load;
  const double scale = system.load.cwiseAbs().sum();
  if (pushed.cwiseAbs().maxCoeff() <= unbalanced * scale) return;

  const Eigen::MatrixXd forces = extreme_forces(line, law, motions);
  const Eigen::VectorXd left = pushed + forces * nonnegative_least_squares(forces, -pushed);
  if (left.norm() > unbalanced * scale)
    refuse("no equilibrium: the loads push the body in a ", motion_in_words(mesh, motions * left),
           ", which neither prescribed displacements nor contact forces oppose");
}

}  // namespace ffcontact
