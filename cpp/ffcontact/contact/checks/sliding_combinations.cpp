// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_combinations.hpp"

#include <algorithm>

#include "ffcontact/linear/dense/singular_values.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Contact works on sliding motions by less than this part of what it could: coordinates
/// with six digits turn directions by so much on edges of a hundredth of the body.
constexpr double along_all = 1e-3;
/// Loads that are not balanced by so much, relative to the sum of |b|, are: coordinates
/// have no more digits.
constexpr double of_coordinates = 1e-5;
/// Motions are about 1 in size, and those of a node that has none are of rounding.
constexpr double moves = 1e-3;
constexpr double rounding_of_directions = 1e-14;

/// Orthonormal columns that span those of a few, but for what is smaller than `moves`.
MatrixXd spanned(const MatrixXd& columns) {
  MatrixXd basis(columns.rows(), 0), left = columns;
  Index largest;
  while (left.cols() > 0 && left.colwise().norm().maxCoeff(&largest) > moves) {
    const VectorXd next = left.col(largest).normalized();
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols<1>() = next;
    left -= next * (next.transpose() * left);
  }
  return basis;
}

}  // namespace

MatrixXd sliding_combinations(const MatrixXd& traces, const MatrixXd& work) {
  const Index motions = traces.cols();
  MatrixXd rows = MatrixXd::Zero(std::max(work.cols(), motions), motions);
  rows.topRows(work.cols()) = work.transpose();
  const MatrixXd V = singular_values(std::move(rows)).V;
  const auto slides = [&](const VectorXd& c) {
    const double size = max_norm(VectorXd(traces * c));
    return size > moves &&
           max_norm(VectorXd(work.transpose() * c)) <= along_all * size;
  };
  Index count = 0;
  while (count < motions && slides(V.col(motions - 1 - count))) ++count;
  return V.rightCols(count);
}

bool is_noise(const VectorXd& load, const MatrixXd& motions) {
  return max_norm(VectorXd(motions.transpose() * load)) <=
         of_coordinates * load.cwiseAbs().sum();
}

VectorXd first_axis_across(const MatrixXd& columns) {
  const VectorXd axis = VectorXd::Unit(columns.rows(), 0);
  const MatrixXd basis = spanned(columns);
  if (basis.cols() == columns.rows() ||
      basis.row(0).norm() <= rounding_of_directions)
    return axis;
  return (axis - basis * basis.row(0).transpose()).normalized();
}

}  // namespace ffcontact
