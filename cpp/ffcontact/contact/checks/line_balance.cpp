// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/line_balance.hpp"

#include <cmath>

#include "ffcontact/base/require.hpp"
#include "ffcontact/contact/checks/balance.hpp"
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"

namespace ffcontact {

MatrixXd extreme_forces(const ContactLine& line, const ContactLaw<2>& law,
                        const MatrixXd& motions) {
  const MatrixXd weighted =
      weight_of_rows(law.multiplier, line) * traces_of(line, motions);
  constexpr int most_forces = 4;
  MatrixXd work(motions.cols(), most_forces * line.node_count());
  Index next = 0;
  for (int i = 0; i < line.node_count(); ++i) {
    const VectorXd n = weighted.row(2 * i), t = weighted.row(2 * i + 1);
    if (law.is_bonded(i)) {
      work.middleCols<most_forces>(next) =
          forces_either_way(weighted.middleRows<2>(2 * i).transpose());
      next += most_forces;
    } else if (law.tresca()) {
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
  return work.leftCols(next);
}

void require_balance(const Mesh& mesh, const ContactLine& line,
                     const ContactLaw<2>& law, const ElasticSystem& system,
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
  if (left.norm() > unbalanced_loads * scale)
    refuse(
        "no contact forces in the cone have the force and the moment of push= "
        "and moment=, or they push the body where nothing holds it: the tool "
        "is drawn away, slides, or tips over an end of the contact line");
}

}  // namespace ffcontact
