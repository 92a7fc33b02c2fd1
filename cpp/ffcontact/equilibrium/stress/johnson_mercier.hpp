// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"

namespace ffcontact {

/// The stress that is linear on the d + 1 subcells of a triangle or a tetrahedron [Johnson,
/// Mercier 1978, and in space].
///
/// The cell is cut at its barycentre G; subcell k lies opposite to vertex k and has the
/// corners k+1, .., k+d, G (modulo d + 1). With continuous tractions on the inner facets,
/// div sigma + f = 0 in each subcell (f constant in each) and linear tractions F on the
/// outer facets, the 27 or 96 coefficients are fixed by the loads of the cell, if these
/// are in equilibrium.

template <int d>
using CellCorners = Matrix<double, d, d + 1>;
using TetrahedronCorners = CellCorners<3>;

/// Moments int F phi [N], F = sigma n with n outward: column d k + j on facet k (opposite
/// to vertex k) at vertex k + 1 + j.
template <int d>
using FacetLoads = Matrix<double, d, d*(d + 1)>;
using FaceLoads = FacetLoads<3>;
/// int f phi_i at the vertices [N]; they fix the constant values of f on the subcells.
template <int d>
using CellBodyLoads = Matrix<double, d, d + 1>;
using SolidBodyLoads = CellBodyLoads<3>;

/// Voigt stresses at the corners of the subcells [MPa]: column (d + 1) k + c is corner c
/// (k+1, .., k+d, G) of subcell k.
template <int d>
using SubcellStress =
    Matrix<double, voigt_size<d>, CompositeElement<d>::values>;
using SolidStress = SubcellStress<3>;

/// 0 and the unit vectors.
template <int d>
CellCorners<d> reference_cell();

/// Vertex k + 1 + j of facet k.
template <int d>
constexpr int vertex_of_facet(int k, int j) {
  return (k + 1 + j) % (d + 1);
}
/// The j with vertex_of_facet(k, j) == vertex.
template <int d>
constexpr int place_on_facet(int k, int vertex) {
  return (vertex + d - k) % (d + 1);
}

/// Columns A_k n_k of the facets, n outward [mm^(d-1)].
template <int d>
CellCorners<d> facet_vectors(const CellCorners<d>& corners);
inline TetrahedronCorners face_vectors(const TetrahedronCorners& corners) {
  return facet_vectors<3>(corners);
}

/// The stress for given loads. Loads out of equilibrium are balanced in the sense of
/// least squares on the reference cell: the caller's equilibrium is the stress's.
///
/// Computed once on the reference cell and carried over by Piola's map x = B xi + x_0:
///     sigma = B s B' / det B,   forces = B (forces)_ref,
/// which keeps symmetry, equilibrium and facet forces.
template <int d>
SubcellStress<d> composite_stress(const CellCorners<d>& corners,
                                  const FacetLoads<d>& on_facets,
                                  const CellBodyLoads<d>& body_loads);

/// int f phi_i for the one f that balances the forces on the facets.
template <int d>
CellBodyLoads<d> balancing_body_loads(const FacetLoads<d>& on_facets);

/// The constant values of f on the subcells [N/mm^d], one column each, for body loads
/// int f phi_i.
template <int d>
CellBodyLoads<d> body_force_of(const CellBodyLoads<d>& body_loads,
                               double volume);

/// B of x = B xi + x_0.
template <int d>
MatrixOf<d> piola_matrix(const CellCorners<d>& corners);

/// T with sigma = T s / det B in Voigt order, for Piola's map sigma = B s B' / det B.
template <int d>
VoigtMatrix<d> piola_voigt(const MatrixOf<d>& B);

/// int sigma : C^-1 sigma over one cell [N mm], exactly.
/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
template <int d>
double energy(const CellCorners<d>& corners, const VoigtMatrix<d>& compliance,
              const SubcellStress<d>& stress);

// What makes a stress one of these, for any values at the corners.

/// div sigma in each subcell [N/mm^d].
template <int d>
CellBodyLoads<d> divergences(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress);

/// Jumps of sigma n across the inner facets [MPa]: column d e + c for the facet of the e-th
/// d - 1 vertices (0, 1, 2, or 01, 02, 03, 12, 13, 23) and G, at these and at G.
template <int d>
Matrix<double, d, d * d*(d + 1) / 2> inner_jumps(
    const CellCorners<d>& corners, const SubcellStress<d>& stress);

/// Moments of the tractions on the outer facets.
template <int d>
FacetLoads<d> facet_loads_of(const CellCorners<d>& corners,
                             const SubcellStress<d>& stress);

/// End values of the linear traction with given moments on a facet of measure A:
/// d (d + 1) / A (b_i - sum of b_j / (d + 1)) [MPa].
template <int d>
MatrixOf<d> facet_density(const MatrixOf<d>& moments, double measure);
inline Matrix3d face_density(const Matrix3d& moments, double area) {
  return facet_density<3>(moments, area);
}

/// Moments of the linear traction with given end values: A / (d (d + 1)) (F_i + sum of F_j)
/// [N].
template <int d>
MatrixOf<d> facet_moments_of(const MatrixOf<d>& density, double measure);
inline Matrix3d face_moments_of(const Matrix3d& density, double area) {
  return facet_moments_of<3>(density, area);
}

}  // namespace ffcontact
