// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/body_loads.hpp"
#include "ffcontact/elastic/hooke.hpp"

namespace ffcontact {

/// Sizes of the composite element of degree 1 in dimension d: the moments of its linear
/// facet tractions are a wrench (force and moment) and self-equilibrated modes, equal and
/// opposite forces at the ends of each side of the facet along it.
template <int d>
struct CompositeElement {
  static constexpr int corners = d + 1;
  static constexpr int voigt = voigt_size<d>;
  static constexpr int wrench = d * (d + 1) / 2;  ///< r, as rigid motions
  static constexpr int turns = wrench - d;
  static constexpr int moments = d * d;  ///< of a facet
  static constexpr int modes = moments - wrench;
  static constexpr int loads = corners * moments;   ///< of a cell's facets
  static constexpr int body_loads = d * corners;    ///< of a cell
  static constexpr int values = corners * corners;  ///< corners of its subcells
};

/// One column of moments, or of a wrench and modes, per facet.
template <int d>
using FacetColumns = Matrix<double, CompositeElement<d>::moments, Dynamic>;

/// Moments int F phi, F = sigma n with n outward: column d k + j on facet k (opposite to
/// vertex k) at vertex k + 1 + j (modulo d + 1). Forces are per unit thickness in the
/// plane [N/mm], and [N] in space.
template <int d>
using FacetLoads = Matrix<double, d, d*(d + 1)>;
/// int f phi_i at the vertices; they fix the constant values of f on the subcells.
template <int d>
using CellBodyLoads = Matrix<double, d, d + 1>;
/// A column of BodyLoadsOfCells.
template <int d>
CellBodyLoads<d> loads_in_cell(const BodyLoadsOfCells<d>& loads, int cell) {
  return loads.col(cell).reshaped(d, d + 1);
}

/// Voigt stresses at the corners of the subcells [MPa]: column (d + 1) k + c is corner c
/// (k+1, .., k+d, G) of subcell k.
template <int d>
using SubcellStress =
    Matrix<double, voigt_size<d>, CompositeElement<d>::values>;

}  // namespace ffcontact
