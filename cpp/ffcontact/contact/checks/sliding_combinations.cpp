// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/contact/checks/sliding_combinations.hpp"

#include "ffcontact/linear/dense/least_squares.hpp"
#include "ffcontact/linear/dense/products.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"
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

/// What columns have across an orthonormal basis.
MatrixXd across(const MatrixXd& basis, const MatrixXd& columns) {
  return columns - basis * (basis.transpose() * columns);
}

/// Orthonormal columns that span those of a few, but for what is smaller than `moves`.
MatrixXd spanned(const MatrixXd& columns) {
  MatrixXd basis(columns.rows(), 0), left = columns;
  Index largest;
  while (left.cols() > 0 && left.colwise().norm().maxCoeff(&largest) > moves) {
    const VectorXd next = left.col(largest).normalized();
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols<1>() = next;
    left = across(next, left);
  }
  return basis;
}

bool slides(const MatrixXd& traces, const MatrixXd& work,
            const VectorXd& motion) {
  const double size = max_norm(VectorXd(traces * motion));
  return size > moves &&
         max_norm(VectorXd(work.transpose() * motion)) <= along_all * size;
}

}  // namespace

Combinations sliding_combinations(const MatrixXd& traces,
                                  const MatrixXd& work) {
  const MatrixXd rows = work.transpose(),
                 V = symmetric_eigen(transposed_product(rows, rows)).vectors;
  Index count = 0;
  while (count < V.cols() && slides(traces, work, V.col(count))) ++count;
  return {V.leftCols(count), V.rightCols(V.cols() - count)};
}

VectorXd lumped_coefficients(const VectorXd& volumes, const MatrixXd& motions,
                             const VectorXd& r) {
  const MatrixXd inertia =
      transposed_product(motions, volumes.asDiagonal() * motions);
  return least_squares(inertia, motions.transpose() * r);
}

double relative_push(const VectorXd& load, const MatrixXd& motions) {
  return relative(max_norm(VectorXd(motions.transpose() * load)),
                  load.cwiseAbs().sum());
}

bool is_noise(const VectorXd& load, const MatrixXd& motions) {
  return relative_push(load, motions) <= of_coordinates;
}

VectorXd first_axis_across(const MatrixXd& columns) {
  const VectorXd axis = VectorXd::Unit(columns.rows(), 0);
  const MatrixXd basis = spanned(columns);
  if (basis.cols() == columns.rows() ||
      basis.row(0).norm() <= rounding_of_directions)
    return axis;
  return across(basis, axis).col(0).normalized();
}

}  // namespace ffcontact
