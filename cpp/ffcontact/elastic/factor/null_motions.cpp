// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/null_motions.hpp"

#include <limits>

namespace ffcontact {

namespace {

/// What is left of a column beside the others, relative to itself, if it depends on them.
constexpr double of_dependent = 1e-10;

/// Columns that span those of M, by Gram and Schmidt, each projected twice.
MatrixXd orthonormal(const MatrixXd& M) {
  MatrixXd Q(M.rows(), M.cols());
  Index rank = 0;
  for (Index j = 0; j < M.cols(); ++j) {
    VectorXd column = M.col(j);
    const double size = column.norm();
    for (int twice = 0; twice < 2; ++twice)
      column -= Q.leftCols(rank) * (Q.leftCols(rank).transpose() * column);
    const double left = column.norm();
    if (left > of_dependent * size) Q.col(rank++) = column / left;
  }
  return Q.leftCols(rank);
}

}  // namespace

MatrixXd without_stiffness_of(const MatrixXd& motions, MatrixXd S) {
  if (motions.cols() == 0 || S.rows() == 0) return S;
  const VectorXd
      D = S.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt(),
      inverse = D.cwiseInverse();
  const MatrixXd Q = orthonormal(D.asDiagonal() * motions);
  S = inverse.asDiagonal() * S * inverse.asDiagonal();
  MatrixXd forces = S * Q;                       // S Q
  forces -= 0.5 * Q * (Q.transpose() * forces);  // - Q (Q' S Q) / 2
  S -= Q * forces.transpose() + forces * Q.transpose();
  return D.asDiagonal() * S * D.asDiagonal();
}

}  // namespace ffcontact
