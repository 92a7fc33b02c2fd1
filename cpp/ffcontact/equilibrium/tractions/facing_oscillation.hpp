// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

namespace ffcontact {

/// What a facet of another body that contact facets face in part does not carry of their
/// tractions r: with d the part of r beyond the nearest linear traction there,
///     int d' G d = constant + sum over the facets of R'S R - M'P M,   M = M_0 + sum of W R,
/// R a facet's (r_n, r_t) at its vertices, S the square int r' G r of its traction on what
/// it shares with the facet, M the moments there and P the square of the linear
/// traction by them. Facets whose tractions stay have their part in the constant and M_0.
template <int d>
struct FacingOscillation {
  struct Part {
    int contact;             ///< place among the contact facets of a setting
    FacetMatrix<d> square;   ///< S
    FacetMatrix<d> moments;  ///< W
  };

  std::vector<Part> parts{};
  FacetMatrix<d> of_moments = FacetMatrix<d>::Zero();     ///< P
  FacetVector<d> first_moments = FacetVector<d>::Zero();  ///< M_0
  double first_square = 0;                                ///< the constant

  /// @param tractions  R of all contact facets, one column a vertex
  FacetVector<d> moments(const std::vector<MatrixOf<d>>& tractions) const;
  double value(const std::vector<MatrixOf<d>>& tractions) const;
  /// Half its slope by the tractions of one part.
  FacetVector<d> slope(const Part& part,
                       const std::vector<MatrixOf<d>>& tractions) const;
  /// Half its second derivative by those of two.
  FacetMatrix<d> form(const Part& row, const Part& column) const;
};

}  // namespace ffcontact
