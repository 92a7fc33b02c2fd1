// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>

#include "ffcontact/elastic/hooke.hpp"
#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"

namespace ffcontact {

/// What tractions have beyond the linear ones that sigma_hat carries on each facet.
///
/// sigma_hat carries the linear traction nearest to r in L2, with its force and moment; d = r
/// - that is orthogonal to all linear functions on each facet F, so that on its cell T
///     int_F d . v <= |d|_F' |v|,   |v|^2 = int_T C eps(v) : eps(v)
/// with a finite |d|_F', and a stress tau in equilibrium with d on F and with nothing
/// else has |tau| <= |d|_F'. sigma_hat + tau is statically admissible: in all that e
/// bounds, e + (sum over T of (sum over F of |d|_F')^2)^(1/2) stands in its place.
///
/// With x = B xi + x_0 from the regular cell of edge 1, whose facets have the measure A_1,
/// v = B^-T v_1 has eps(v_1) = B' eps(v) B, tau = B tau_1 B' / det B and
///     |d|_F'^2 = lambda kappa^2 (A / A_1) int_F |B^-1 d|^2,
/// lambda the largest eigenvalue of T' C^-1 T / det B (piola_voigt, on tensors with
/// Frobenius' norm), kappa^2 a bound of |d|'^2 / |d|^2 on the regular cell.
///
/// In the plane d = q (6 s^2 - 6 s + 1) on an edge: kappa^2 = 0.8875 is that of the least
/// quadratic stress on the three subtriangles.
///
/// In space kappa^2 = 2.29: cut F into k^2 triangles of edge 1/k, d = d_k + what is
/// orthogonal to linear functions on each of them. The least stress that is linear on the
/// subtetrahedra of a mesh with these faces gives |d_k|' <= kappa_k |d_k|; on each small
/// triangle stands a regular tetrahedron of edge 1/k inside the large one, no two of which
/// overlap, where the rest is bounded by kappa k^(-1/2). So
///     kappa^2 <= kappa_k^2 + kappa^2 / k,   kappa_4^2 = 1.717 (2: 2.016, 3: 1.860, 5: 1.630, 6: 1.574).
template <int d>
constexpr double traction_constant = d == 2 ? 0.8875 : 2.29;

/// The regular triangle or tetrahedron of edge 1.
template <int d>
CellCorners<d> regular_cell();

/// |d|_F'^2 of one facet of a cell.
/// @param square  int_F d d' [N^2/mm^2, in the plane N^2/mm^3]
template <int d>
double facet_oscillation_square(const CellCorners<d>& corners,
                                const VoigtMatrix<d>& compliance,
                                double measure, const MatrixOf<d>& square);

/// G with |d|_F'^2 = int_F d' G d.
template <int d>
MatrixOf<d> facet_oscillation_form(const CellCorners<d>& corners,
                                   const VoigtMatrix<d>& compliance,
                                   double measure);

/// (sum over T of (sum over F of |d|_F')^2)^(1/2) as it grows.
class OscillationSum {
 public:
  void add(int cell, double square) { of_cell_[cell] += std::sqrt(square); }
  double norm() const {
    double sum = 0;
    for (const auto& [cell, oscillation] : of_cell_)
      sum += oscillation * oscillation;
    return std::sqrt(sum);
  }

 private:
  std::map<int, double> of_cell_;
};

}  // namespace ffcontact
