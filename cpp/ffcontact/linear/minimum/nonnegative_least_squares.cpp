// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/linear/minimum/nonnegative_least_squares.hpp"

#include <limits>
#include <vector>

#include "ffcontact/base/flags.hpp"
#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Least squares over the columns in the passive set; the others are zero.
VectorXd passive_solution(const MatrixXd& G, const VectorXd& b,
                          const Flags& passive) {
  std::vector<Index> columns;
  for (Index j = 0; j < G.cols(); ++j)
    if (passive[j]) columns.push_back(j);
  MatrixXd selected(G.rows(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    selected.col(k) = G.col(columns[k]);
  const VectorXd z = least_squares(selected, b);
  VectorXd x = VectorXd::Zero(G.cols());
  for (std::size_t k = 0; k < columns.size(); ++k) x[columns[k]] = z[k];
  return x;
}

/// Largest step from x towards z that keeps x >= 0; the columns that reach 0 leave the
/// passive set.
VectorXd step_inside(const VectorXd& x, const VectorXd& z, Flags& passive) {
  double step = 1;
  for (Index j = 0; j < x.size(); ++j)
    if (passive[j] && z[j] <= 0) step = std::min(step, x[j] / (x[j] - z[j]));
  VectorXd next = x + step * (z - x);
  for (Index j = 0; j < x.size(); ++j)
    if (passive[j] && z[j] <= 0 && next[j] <= 1e-14 * max_norm(x)) {
      passive[j] = 0;
      next[j] = 0;
    }
  return next;
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& G, const VectorXd& b) {
  const double tolerance = 1e-12 * b.norm() * G.colwise().norm().maxCoeff();
  Flags passive(G.cols(), 0);
  VectorXd x = VectorXd::Zero(G.cols());
  for (Index round = 0; round < 3 * G.cols(); ++round) {
    VectorXd descent = G.transpose() * (b - G * x);
    for (Index j = 0; j < G.cols(); ++j)
      if (passive[j]) descent[j] = 0;
    Index entering = 0;
    if (descent.maxCoeff(&entering) <= tolerance) break;
    passive[entering] = 1;
    VectorXd z = passive_solution(G, b, passive);
    if (z[entering] <= 0) {  // dependent to rounding on the columns that are in
      passive[entering] = 0;
      break;
    }
    const auto leaves = [&] {
      for (Index j = 0; j < G.cols(); ++j)
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
