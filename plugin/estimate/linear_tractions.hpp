// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/linear/norms.hpp"
//
#include "freefem/body_values.hpp"

namespace ffcontact::plugin {

/// Beside the largest value: more is not rounding.
constexpr double linear_to = 1e-9;

/// Places on a facet that no odd or even function passes; the first d are near its vertices.
template <int d>
Matrix<double, d, Dynamic> places_of_a_facet() {
  Matrix<double, d, Dynamic> hats;
  if constexpr (d == 2) {
    hats.resize(2, 7);
    hats.row(1) << 1e-3, 1 - 1e-3, 0.113, 0.31, 0.5, 0.74, 0.887;
    hats.row(0) = 1 - hats.row(1).array();
  } else {
    const std::vector<Vector3d> places = {{1 - 2e-3, 1e-3, 1e-3},
                                          {0.74, 0.15, 0.11},
                                          {0.577, 0.31, 0.113},
                                          {0.31, 0.577, 0.113}};
    hats.resize(3, 12);
    for (int q = 0; q < 12; ++q)
      for (int k = 0; k < 3; ++k) hats((k + q) % 3, q) = places[q / 3][k];
  }
  return hats;
}

/// Do body forces have more than a constant in each cell, beyond rounding?
/// @param loads  of the cells, of all forces
inline bool vary_in_cells(double oscillation,
                          const Ref<const MatrixXd>& loads) {
  return oscillation > linear_to * loads.cwiseAbs().sum();
}

/// What a function has on each boundary element beyond the linear one through its values near
/// the vertices.
struct Bends {
  VectorXd off;        ///< [boundary]
  double largest = 0;  ///< of all values
};

template <int d>
Bends bends_of(Stack stack, Expression w, const BodyPart<d>& part) {
  const Matrix<double, d, Dynamic> hats = places_of_a_facet<d>();
  const MatrixXd values = along_boundary<d>(stack, w, part, hats);
  if (values.cols() == 0) return {};
  const MatrixOf<d> first = hats.template leftCols<d>().transpose();
  const MatrixXd linear =
      hats.transpose() * first.inverse() * values.topRows(d);
  return {(values - linear).cwiseAbs().colwise().maxCoeff(), max_norm(values)};
}

}  // namespace ffcontact::plugin
