// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

namespace ffcontact {

/// A form in the unknowns of all facets of a cell, and a vector of these.
template <int d, class Scalar = double>
using CellForm =
    Matrix<Scalar, CompositeElement<d>::loads, CompositeElement<d>::loads>;
template <int d>
using CellVector = Matrix<double, CompositeElement<d>::loads, 1>;
/// The columns of each facet's unknowns.
template <int d>
using FacetBases = std::array<FacetMatrix<d>, d + 1>;

/// The energy of a cell's composite stress as a form in the loads on its facets, body loads
/// being those that balance them (balancing_body_loads):
///     int sigma : C^-1 sigma = x' H x,   loads of facet k (FacetLoads, column-major) = basis[k] x_k.
///
/// With Piola's map sigma = T s / det B and s = L b_ref the reference cell has 6 or 21
/// matrices P_ab, one for each pair of Voigt components, and
///     H_ref = sum of M_ab P_ab,   M = T' C^-1 T / det B,   b = B b_ref:
/// in space 21 x 666 products, and 2 x 36 x 36 x 9 for the basis.
/// @tparam Scalar     float for what only steers
/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
template <int d, class Scalar = double>
CellForm<d, Scalar> facet_energy(const CellCorners<d>& corners,
                                 const VoigtMatrix<d>& compliance,
                                 const FacetBases<d>& basis);

/// g with int sigma : C^-1 tau = g' x for the stress tau of these loads x.
/// @param stress  sigma
template <int d>
CellVector<d> facet_slope(const CellCorners<d>& corners,
                          const VoigtMatrix<d>& compliance,
                          const SubcellStress<d>& stress,
                          const FacetBases<d>& basis);

}  // namespace ffcontact
