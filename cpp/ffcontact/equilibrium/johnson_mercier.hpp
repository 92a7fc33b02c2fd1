// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/base/eigen.hpp"

namespace ffcontact {

/// The stress that is linear on the four subtetrahedra of a tetrahedron [Johnson, Mercier
/// 1978, in space].
///
/// The tetrahedron is cut at its barycentre G; subtetrahedron k lies opposite to vertex k
/// and has the corners k+1, k+2, k+3, G (modulo 4). With continuous tractions on the six
/// inner faces, div sigma + f = 0 in each subtetrahedron (f constant in each) and linear
/// tractions F on the outer faces, the 96 coefficients are fixed by the loads of the
/// tetrahedron, if these are in equilibrium.

/// Moments int F phi [N], F = sigma n with n outward: column 3 k + j on face k (opposite
/// to vertex k) at vertex k + 1 + j.
using FaceLoads = Matrix<double, 3, 12>;
/// int f phi_i at the four vertices [N]; they fix the four constant values of f.
using SolidBodyLoads = Matrix<double, 3, 4>;

/// Voigt stresses at the corners of the subtetrahedra [MPa]: column 4 k + c is corner c
/// (k+1, k+2, k+3, G) of subtetrahedron k.
using SolidStress = Matrix<double, 6, 16>;

using TetrahedronCorners = Matrix<double, 3, 4>;

/// 0 and the three unit vectors.
TetrahedronCorners reference_tetrahedron();

/// Vertex k + 1 + j of face k.
constexpr int vertex_of_face(int k, int j) { return (k + 1 + j) % 4; }
/// The j with vertex_of_face(k, j) == vertex.
constexpr int place_on_face(int k, int vertex) { return (vertex + 3 - k) % 4; }

/// Columns A_k n_k of the four faces, n outward [mm^2].
TetrahedronCorners face_vectors(const TetrahedronCorners& corners);

/// The stress for given loads. Loads out of equilibrium are balanced in the sense of
/// least squares on the reference tetrahedron: the caller's equilibrium is the stress's.
///
/// Computed once on the reference tetrahedron and carried over by Piola's map x = B xi +
/// x_0:
///     sigma = B s B' / det B,   forces = B (forces)_ref,
/// which keeps symmetry, equilibrium and face forces.
SolidStress composite_stress(const TetrahedronCorners& corners,
                             const FaceLoads& on_faces,
                             const SolidBodyLoads& body_loads);

/// int f phi_i for the one f that balances the forces on the faces.
SolidBodyLoads balancing_body_loads(const FaceLoads& on_faces);

/// The four constant values of f on the subtetrahedra [N/mm^3], one column each, for body
/// loads int f phi_i.
Matrix<double, 3, 4> body_force_of(const SolidBodyLoads& body_loads,
                                   double volume);

/// B of x = B xi + x_0.
Matrix3d piola_matrix(const TetrahedronCorners& corners);

/// T with sigma = T s / det B in Voigt order, for Piola's map sigma = B s B' / det B.
Matrix<double, 6, 6> piola_voigt(const Matrix3d& B);

/// int sigma : C^-1 sigma over one tetrahedron [N mm], exactly.
/// @param compliance  C^-1 in Voigt order with engineering shear [1/MPa]
double energy(const TetrahedronCorners& corners,
              const Matrix<double, 6, 6>& compliance,
              const SolidStress& stress);

// What makes a stress one of these, for any values at the corners.

/// div sigma in each subtetrahedron [N/mm^3].
Matrix<double, 3, 4> divergences(const TetrahedronCorners& corners,
                                 const SolidStress& stress);

/// Jumps of sigma n across the inner faces [MPa]: column 3 e + c for the face of edge e
/// (01, 02, 03, 12, 13, 23) and G, at the edge's two ends and at G.
Matrix<double, 3, 18> inner_jumps(const TetrahedronCorners& corners,
                                  const SolidStress& stress);

/// Moments of the tractions on the outer faces.
FaceLoads face_loads_of(const TetrahedronCorners& corners,
                        const SolidStress& stress);

/// End values of the linear traction with given moments on a face of area A: 12/A (b_i -
/// sum of b_j / 4) [MPa].
Matrix3d face_density(const Matrix3d& moments, double area);

/// Moments of the linear traction with given end values: A/12 (F_i + sum of F_j) [N].
Matrix3d face_moments_of(const Matrix3d& density, double area);

}  // namespace ffcontact
