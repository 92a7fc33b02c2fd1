// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/facing_oscillation.hpp"

namespace ffcontact {

template <int d>
FacetVector<d> FacingOscillation<d>::moments(
    const std::vector<MatrixOf<d>>& tractions) const {
  FacetVector<d> sum = first_moments;
  for (const Part& part : parts)
    sum += part.moments * tractions[part.contact].reshaped();
  return sum;
}

template <int d>
double FacingOscillation<d>::value(
    const std::vector<MatrixOf<d>>& tractions) const {
  const FacetVector<d> M = moments(tractions);
  double square = first_square - M.dot(of_moments * M);
  for (const Part& part : parts) {
    const FacetVector<d> R = tractions[part.contact].reshaped();
    square += R.dot(part.square * R);
  }
  return square;
}

template <int d>
FacetVector<d> FacingOscillation<d>::slope(
    const Part& part, const std::vector<MatrixOf<d>>& tractions) const {
  return part.square * tractions[part.contact].reshaped() -
         part.moments.transpose() * (of_moments * moments(tractions));
}

template <int d>
FacetMatrix<d> FacingOscillation<d>::form(const Part& row,
                                          const Part& column) const {
  FacetMatrix<d> form = -row.moments.transpose() * of_moments * column.moments;
  if (row.contact == column.contact) form += row.square;
  return form;
}

template struct FacingOscillation<FFCONTACT_DIMENSION>;

}  // namespace ffcontact
