// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/equilibrium/stress/polynomial_basis.hpp"

namespace ffcontact {

/// The stress sigma = C eps(w), w of degree 4 on one triangle, that takes the loads in
/// the mean [CHH01, 4.2.2, numerical]:
///     int C eps(w) : eps(v) = int f . v + sum over the edges of int F . v    for all v of degree 4.
/// div sigma + f = 0 and sigma n = F hold only against such v, not at every point, so
/// that the stress is not admissible and its distance to C eps(u_h) is no bound. On
/// example 1 of the paper it is 13 % smaller than that of the composite stress for the
/// first densities, and 0.6 % after two sweeps of star relaxation. Left out: any control
/// of the jumps between triangles. All integrals are exact (PolynomialBasis), in reference
/// coordinates x = B (xi, eta) + x_0.
struct PolynomialStress {
  CellCorners<2> corners;
  Matrix3d hooke;  ///< C in Voigt order with engineering shear [MPa]
  /// coefficients of w on the orthonormal basis, without rigid motion [mm]
  Matrix<double, 2, polynomial_count> displacement;
};

/// @param on_edges    moments of linear densities F, as for composite_stress, in balance
///                    with the body loads [N/mm]
/// @param body_loads  int f phi_i at the three vertices; f is taken as the linear
///                    function with these moments
PolynomialStress polynomial_stress(const CellCorners<2>& corners,
                                   const Matrix3d& hooke,
                                   const FacetLoads<2>& on_edges,
                                   const CellBodyLoads<2>& body_loads);

/// Voigt stress [MPa] at a point of the triangle [mm].
Vector3d stress_at(const PolynomialStress& stress, const Vector2d& point);

/// Point values at the corners of the subtriangles.
SubcellStress<2> corner_values(const PolynomialStress& stress);

/// int (sigma + s) : C^-1 (sigma + s) over the triangle for a linear stress s [N/mm per
/// unit thickness times mm].
/// @param at_vertices  values of s
double energy(const PolynomialStress& stress, const Matrix3d& at_vertices);

}  // namespace ffcontact
