// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/boundary_tractions.hpp"
#include "ffcontact/equilibrium/composite_stress.hpp"
#include "ffcontact/mesh/stars.hpp"

namespace ffcontact {

/// Edge loads of every triangle [14 x triangles], in the layout of TriangleLoads.
using LoadsPerTriangle = Eigen::Matrix<double, 14, Eigen::Dynamic>;

/// The loads of sigma_hat - sigma on each triangle, where sigma_hat has the given edge moments and body forces and sigma is
/// constant per triangle. They are in equilibrium on every triangle when sigma_hat is.
LoadsPerTriangle difference_loads(const Mesh& mesh, const Edges& edges, const EdgeMoments& moments,
                                  const Eigen::Ref<const Eigen::Matrix2Xd>& body_force,
                                  const Eigen::Ref<const Eigen::Matrix3Xd>& stress);

/// Star relaxation: lowers |sigma_hat - C eps(u_hat)|^2 and keeps equilibrium exactly.
///
/// Corrections that keep equilibrium are the stresses of Airy functions A in the Hsieh-Clough-Tocher space. Those carried by
/// the edges at one vertex i (spokes i -> j) have the unknowns A, grad A at i and dA/dn at the middle of each spoke; A and
/// grad A vanish on the rim of the star. With psi = (A_y, -A_x) the traction along a spoke is d psi/ds, linear, with moments
///     b_i = (-5 psi_i + 4 psi_m) / 6,   b_j = (-psi_i - 4 psi_m) / 6,
/// psi_m from dA/dn and dA/ds = -3/2 A_i/l - 1/4 dA/ds_i at the middle. A known traction component c of a boundary spoke asks
/// psi_c = 0 at i and at the middle. Each vertex is a small positive definite problem; one sweep visits all vertices.
///
/// Vertices of one colour share no triangle and run in parallel; the result does not depend on the number of threads.
/// @param difference  loads of sigma_hat - C eps(u_hat), relaxed in place
/// @return |sigma_hat - C eps(u_hat)|^2 before the first and after every sweep [N/mm per unit thickness times mm], sweeps + 1
std::vector<double> relax_stars(const Mesh& mesh, const Edges& edges, const Stars& stars, const Hooke& hooke,
                                const BoundaryTractions& boundary, int sweeps, LoadsPerTriangle& difference);

}  // namespace ffcontact
