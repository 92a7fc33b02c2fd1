// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/estimate/error/between_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace ffcontact {

namespace {

/// Directions that differ by less are the same but for rounding [rad].
constexpr double least_turn = 1e-11;
/// In parts of the vector.
constexpr double rounding_of_component = 1e-15;

/// Weights of the corners at the points that are tested, one column each.
MatrixXd tested_points(Index corners) {
  constexpr int of_side = 4;
  MatrixXd weights = MatrixXd::Zero(corners, of_side * corners + 1);
  for (Index k = 0; k < corners; ++k)
    for (int quarter = 0; quarter < of_side; ++quarter) {
      const double along = static_cast<double>(quarter) / of_side;
      weights(k, of_side * k + quarter) += 1 - along;
      weights((k + 1) % corners, of_side * k + quarter) += along;
    }
  weights.rightCols<1>().setConstant(1.0 / static_cast<double>(corners));
  return weights;
}

template <int dim>
double largest_turn(const Matrix<double, dim, Dynamic>& normals) {
  double largest = 0;
  for (Index i = 0; i < normals.cols(); ++i)
    for (Index j = 0; j < i; ++j) {
      const double half = (normals.col(i) - normals.col(j)).norm() / 2;
      largest = std::max(largest, 2 * std::asin(std::min(1.0, half)));
    }
  return largest > least_turn ? largest : 0;
}

}  // namespace

template <int dim>
void note(const FacetFields<dim>& fields,
          const Matrix<double, dim, Dynamic>& normals_of_nodes, int facet,
          BetweenNodes& found) {
  bool matters = !fields.traction.isZero(0);
  const MatrixXd points = tested_points(fields.normal.cols());
  for (const auto& weights : points.colwise()) {
    using Vector = VectorOf<dim>;
    const Vector n = (fields.normal * weights).normalized(),
                 r = fields.traction * weights, w = fields.motion * weights;
    const double rn = r.dot(n), wn = w.dot(n);
    const Vector rt = r - rn * n, wt = w - wn * n;
    const double slip = wt.norm();
    double f = rt.dot(wt) + rn * wn;
    // with a large mu what carries r_t may be less than the rounding of r . n
    const double pressing = rn - rounding_of_component * r.norm();
    if (slip > 0)
      f += cone_between(fields.cone, weights).bound(pressing) * slip;
    matters = matters || wn > 0;
    if (-f <= found.negative) continue;
    found.negative = -f;
    found.negative_facet = facet;
  }
  const double turn = matters ? largest_turn<dim>(normals_of_nodes) : 0;
  if (turn <= found.turn) return;
  found.turn = turn;
  found.turned_facet = facet;
}

template void note<FFCONTACT_DIMENSION>(
    const FacetFields<FFCONTACT_DIMENSION>&,
    const Matrix<double, FFCONTACT_DIMENSION, Dynamic>&, int, BetweenNodes&);

}  // namespace ffcontact
