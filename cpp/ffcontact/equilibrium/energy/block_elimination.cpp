// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/energy/block_elimination.hpp"

#include <cmath>
#include <limits>

namespace ffcontact {

void BlockElimination::append(const MatrixXd& next, const MatrixXd& coupling) {
  const Index own = A_.rows();
  next_ = next.rows();
  A_.conservativeResize(own + next_, own + next_);
  A_.bottomLeftCorner(next_, own) = coupling;
  A_.bottomRightCorner(next_, next_) = next;
  diagonal_.conservativeResize(own + next_);
  diagonal_.tail(next_) = next.diagonal();
}

bool BlockElimination::is_dependent(Index column) const {
  constexpr double nothing = 1e-11;
  return !(A_(column, column) > nothing * diagonal_[column]);
}

void BlockElimination::eliminate(Index column) {
  const Index rest = A_.rows() - column - 1;
  auto below = A_.col(column).tail(rest);
  if (is_dependent(column)) {
    A_(column, column) = std::numeric_limits<double>::infinity();
    below.setZero();
    return;
  }
  A_(column, column) = std::sqrt(A_(column, column));
  below /= A_(column, column);
  A_.bottomRightCorner(rest, rest)
      .selfadjointView<Eigen::Lower>()
      .rankUpdate(below, -1);
}

MatrixXd BlockElimination::eliminated() {
  const Index own = present();
  for (Index column = 0; column < own; ++column) eliminate(column);
  const MatrixXd columns = A_.leftCols(own);
  A_ = A_.bottomRightCorner(next_, next_).eval();
  diagonal_ = diagonal_.tail(next_).eval();
  next_ = 0;
  return columns;
}

}  // namespace ffcontact
