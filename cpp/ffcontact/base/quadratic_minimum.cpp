// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/quadratic_minimum.hpp"

#include <Eigen/Cholesky>

#include "ffcontact/base/nonnegative_least_squares.hpp"

namespace ffcontact {

std::optional<Eigen::VectorXd> quadratic_minimum(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                 const Eigen::MatrixXd& C, const Eigen::VectorXd& d) {
  const Eigen::LLT<Eigen::MatrixXd> llt(H);
  if (llt.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd free = -llt.solve(g);
  const Eigen::VectorXd missing = d - C * free;  // conditions on the step away from the free minimum
  if (missing.size() == 0 || missing.maxCoeff() <= 0) return free;

  // Rows scaled to length 1: least distance does not care, its rounding does.
  Eigen::MatrixXd G = llt.matrixL().solve(C.transpose()).transpose();
  Eigen::VectorXd h = missing;
  for (Eigen::Index row = 0; row < G.rows(); ++row) {
    const double length = G.row(row).norm();
    if (length == 0) continue;
    G.row(row) /= length;
    h[row] /= length;
  }
  const double scale = h.cwiseAbs().maxCoeff();
  Eigen::MatrixXd dual(G.cols() + 1, G.rows());
  dual << G.transpose(), h.transpose() / scale;
  const Eigen::VectorXd target = Eigen::VectorXd::Unit(G.cols() + 1, G.cols());
  const Eigen::VectorXd residual = dual * nonnegative_least_squares(dual, target) - target;
  const double last = residual[G.cols()];
  if (!(last < -1e-12)) return std::nullopt;
  const Eigen::VectorXd z = -scale / last * residual.head(G.cols());
  return free + llt.matrixL().transpose().solve(z);
}

}  // namespace ffcontact
