// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The stress that is linear on the three subtriangles of a triangle [Johnson, Mercier
/// 1978; CHH01, 4.2.2, analytical].
///
/// The triangle is cut at its centroid G; subtriangle k lies opposite to vertex k and has
/// the corners k+1, k+2, G. With continuous tractions on the inner edges, div sigma + f =
/// 0 in each subtriangle (f constant in each) and linear tractions F on the outer edges,
/// the 27 coefficients are fixed by the loads of the triangle, if these are in
/// equilibrium.
///
/// Edge loads [12]: for each edge k (opposite to vertex k, from vertex k+1 to k+2) the
/// moments b = int F phi at k+1 and at k+2, F = sigma n with n outward, two components
/// each. Body loads [6]: int f phi_i at the three vertices; they fix the three constant
/// values of f. All are forces per unit thickness [N/mm].
using EdgeLoads = Matrix<double, 12, 1>;
using BodyLoads = Matrix<double, 6, 1>;
using BodyLoadsOfAll = Matrix<double, 6, Dynamic>;  ///< per triangle

/// Voigt stresses at the corners of the subtriangles [MPa]: column 3 k + c is corner c
/// (k+1, k+2, G) of subtriangle k.
using CompositeStress = Matrix<double, 3, 9>;

using TriangleCorners = Matrix<double, 2, 3>;

/// (0,0), (1,0), (0,1)
TriangleCorners reference_triangle();

/// Side k of a triangle, from vertex k+1 to k+2.
inline Vector2d side_of(const TriangleCorners& corners, int k) {
  return corners.col((k + 2) % 3) - corners.col((k + 1) % 3);
}

/// Corners k+1, k+2, G of subtriangle k.
inline TriangleCorners subtriangle(const TriangleCorners& corners, int k) {
  TriangleCorners sub;
  sub << corners.col((k + 1) % 3), corners.col((k + 2) % 3),
      corners.rowwise().mean();
  return sub;
}

/// The stress for given loads. Loads out of equilibrium are balanced in the sense of
/// least squares on the reference triangle: the caller's equilibrium is the stress's.
///
/// Computed once on the reference triangle and carried over by Piola's map x = B xi +
/// x_0:
///     sigma = B s B' / det B,   forces = B (forces)_ref,
/// which keeps symmetry, equilibrium and edge forces. On triangles thinner than 1 : 16
/// the conditions are solved directly.
CompositeStress composite_stress(const TriangleCorners& corners,
                                 const EdgeLoads& on_edges,
                                 const BodyLoads& body_loads);

/// B of x = B xi + x_0.
Matrix2d piola_matrix(const TriangleCorners& corners);

/// T with sigma = T s / det B in Voigt order, for Piola's map sigma = B s B' / det B.
Matrix3d piola_voigt(const Matrix2d& B);

/// The three constant values of f on the subtriangles [N/mm^3], one column each, for body
/// loads int f phi_i.
Matrix<double, 2, 3> body_force_of(const BodyLoads& body_loads, double area);

/// int sigma : C^-1 sigma over one triangle [N/mm per unit thickness times mm], exactly.
double energy(const TriangleCorners& corners, const Matrix3d& compliance,
              const CompositeStress& stress);

/// End values of the linear density with moments b_i, b_j on an edge: (2 / l) (2 b_i -
/// b_j) at i [MPa].
/// @param moments  (b_i, b_j), two components each
/// @return (F_i, F_j)
Vector4d density_of_moments(const Vector4d& moments, double length);

/// Moments of the linear density with end values F_i, F_j: l (2 F_i + F_j) / 6 at i.
Vector4d moments_of_density(const Vector4d& density, double length);

}  // namespace ffcontact
