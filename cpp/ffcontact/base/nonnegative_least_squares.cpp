// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/nonnegative_least_squares.hpp"

#include <limits>
#include <vector>

#include "ffcontact/base/least_squares.hpp"

namespace ffcontact {

namespace {

/// Least squares over the columns in the passive set; the others are zero.
Eigen::VectorXd passive_solution(const Eigen::MatrixXd& G, const Eigen::VectorXd& b, const std::vector<char>& passive) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    if (passive[j]) columns.push_back(j);
  Eigen::MatrixXd selected(G.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) selected.col(k) = G.col(columns[k]);
  const Eigen::VectorXd z = least_squares(selected, b);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(G.cols());
  for (std::size_t k = 0; k < columns.size(); ++k) x[columns[k]] = z[k];
  return x;
}

/// Largest step from x towards z that keeps x >= 0; the columns that reach 0 leave the passive set.
Eigen::VectorXd step_inside(const Eigen::VectorXd& x, const Eigen::VectorXd& z, std::vector<char>& passive) {
  double step = 1;
  for (Eigen::Index j = 0; j < x.size(); ++j)
    if (passive[j] && z[j] <= 0) step = std::min(step, x[j] / (x[j] - z[j]));
  Eigen::VectorXd next = x + step * (z - x);
  for (Eigen::Index j = 0; j < x.size(); ++j)
    if (passive[j] && z[j] <= 0 && next[j] <= 1e-14 * x.cwiseAbs().maxCoeff()) {
      passive[j] = 0;
      next[j] = 0;
    }
  return next;
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& G, const Eigen::VectorXd& b) {
  const double tolerance = 1e-12 * b.norm() * G.colwise().norm().maxCoeff();
  std::vector<char> passive(G.cols(), 0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(G.cols());
  for (Eigen::Index round = 0; round < 3 * G.cols(); ++round) {
    Eigen::VectorXd descent = G.transpose() * (b - G * x);
    for (Eigen::Index j = 0; j < G.cols(); ++j)
      if (passive[j]) descent[j] = 0;
    Eigen::Index entering = 0;
    if (descent.maxCoeff(&entering) <= tolerance) break;
    passive[entering] = 1;
    Eigen::VectorXd z = passive_solution(G, b, passive);
    if (z[entering] <= 0) {  // dependent to rounding on the columns that are in
      passive[entering] = 0;
      break;
    }
    const auto leaves = [&] {
      for (Eigen::Index j = 0; j < G.cols(); ++j)
        if (passive[j] && z[j] <= 0) return true;
      return false;
    };
    while (leaves()) {
      x = step_inside(x, z, passive);
      z = passive_solution(G, b, passive);
    }
    x = z;
  }
  return x;
}

}  // namespace ffcontact
