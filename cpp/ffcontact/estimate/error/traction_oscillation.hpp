// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/interface/contact_surface.hpp"

namespace ffcontact {

/// What contact tractions have beyond the linear ones that sigma_hat carries on each face.
///
/// Where surfaces do not match r is linear on the polygons of their common refinement, on
/// faces of the opposite body and on those that face it in part. sigma_hat carries the
/// linear traction nearest to it in L2, with its force and moment; d = r - that is
/// orthogonal to all linear functions on each face F, so that on its tetrahedron T
///     int_F d . v <= |d|_F' |v|,   |v|^2 = int_T C eps(v) : eps(v)
/// with a finite |d|_F', and a stress tau in equilibrium with d on F and with nothing
/// else has |tau| <= |d|_F'. sigma_hat + tau is statically admissible: in all that e
/// bounds, e + (sum over T of (sum over F of |d|_F')^2)^(1/2) stands in its place.
///
/// With x = B xi + x_0 from the regular tetrahedron of edge 1, whose faces have the area
/// A_1 = sqrt(3)/4, v = B^-T v_1 has eps(v_1) = B' eps(v) B, tau = B tau_1 B' / det B and
///     |d|_F'^2 = lambda kappa^2 (A / A_1) int_F |B^-1 d|^2,
/// lambda the largest eigenvalue of T' C^-1 T / det B (piola_voigt, on tensors with
/// Frobenius' norm).
///
/// kappa^2 = 2.29 bounds |d|'^2 / |d|^2 on the regular tetrahedron: cut F into k^2
/// triangles of edge 1/k, d = d_k + what is orthogonal to linear functions on each of
/// them. The least stress that is linear on the subtetrahedra of a mesh with these faces
/// gives |d_k|' <= kappa_k |d_k|; on each small triangle stands a regular tetrahedron of
/// edge 1/k inside the large one, no two of which overlap, where the rest is bounded by
/// kappa k^(-1/2). So
///     kappa^2 <= kappa_k^2 + kappa^2 / k,   kappa_4^2 = 1.717 (2: 2.016, 3: 1.860, 5: 1.630, 6: 1.574).
constexpr double traction_constant = 2.29;

/// |d|_F'^2 of one face of a tetrahedron.
/// @param square  int_F d d' [N^2/mm^2]
double face_oscillation_square(const CellCorners<3>& corners,
                               const Matrix<double, 6, 6>& compliance,
                               double face_area, const Matrix3d& square);

/// (sum over T of (sum over F of |d|_F')^2)^(1/2) [(N mm)^(1/2)]. Integrals are exact on
/// the polygons, those that overlap on a face included; what is smaller than 1e-12 of a
/// face is rounding.
/// @param traction  r_hat at the nodes [MPa, 3 x p]
double traction_oscillation(const SolidMesh& mesh, const Facets<3>& faces,
                            const ContactSurface& surface,
                            const HookeTensors<3>& hooke,
                            const Ref<const Matrix3Xd>& traction);

}  // namespace ffcontact
