// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "ffcontact/equilibrium/stress/johnson_mercier.hpp"
#include "ffcontact/mesh/facet_topology.hpp"

namespace ffcontact {

using Matrix6d = Matrix<double, 6, 6>;
using Vector6d = Matrix<double, 6, 1>;
using Matrix9d = Matrix<double, 9, 9>;
using Vector9d = Matrix<double, 9, 1>;

/// Columns of one facet's unknowns.
template <int d>
using FacetMatrix =
    Matrix<double, CompositeElement<d>::moments, CompositeElement<d>::moments>;
template <int d>
using FacetVector = Matrix<double, CompositeElement<d>::moments, 1>;
template <int d>
using Wrench = Matrix<double, CompositeElement<d>::wrench, 1>;
template <int d>
using WrenchMatrix =
    Matrix<double, CompositeElement<d>::wrench, CompositeElement<d>::wrench>;
/// f -> a x f, the moment of a force
template <int d>
using MomentMatrix = Matrix<double, CompositeElement<d>::turns, d>;
/// Columns of moments for a wrench.
template <int d>
using WrenchMoments =
    Matrix<double, CompositeElement<d>::moments, CompositeElement<d>::wrench>;

/// The moments b of a facet by its wrench w and the forces y of its modes:
///     b = V (w, y),   w = (sum of b_i, sum of (x_i - x_F) x b_i / h_F),   x_F the centroid, h_F = A^(1/(d-1)),
/// all in N. Mode k pushes the ends of a side apart: of the edge itself in the plane, of
/// the side opposite to vertex k in space. The wrench without modes has the least moments,
/// W'(W W')^-1 w (wrench_moments). A cell stays balanced if and only if the wrenches of its
/// facets, seen outward, add to zero.
template <int d>
FacetMatrix<d> wrench_basis(const MatrixOf<d>& facet_corners);
template <int d>
WrenchMoments<d> wrench_moments(const MatrixOf<d>& facet_corners);

/// h_F [mm]
template <int d>
double size_of_facet(const MatrixOf<d>& facet_corners);

template <int d>
MomentMatrix<d> moment_matrix(const VectorOf<d>& arm);

/// The wrench that all facets around a ridge of size h_e and middle x_e carry, seen across
/// them in the direction in which they turn about it:
///     w_e = (f, m / h_e), m about x_e,   w_F = s_F Shift w_e,   m_F = m - (x_F - x_e) x f,
/// with s_F = 1 where the normal of the facet follows the right-hand turn about the ridge.
/// A vertex of the plane is as large as its first edge is long.
template <int d>
struct WrenchShift {
  static constexpr int turns = CompositeElement<d>::turns;

  VectorOf<d> arm;  ///< (x_F - x_e) / h_F
  double ratio;     ///< h_e / h_F
  double sign;      ///< s_F

  /// s_F Shift w
  Wrench<d> times(const Wrench<d>& w) const {
    const VectorOf<d> f = w.template head<d>();
    const Matrix<double, turns, 1> m = w.template tail<turns>();
    Wrench<d> shifted;
    shifted << sign * f, sign * (ratio * m - moment(f));
    return shifted;
  }
  /// s_F Shift' w
  Wrench<d> transposed_times(const Wrench<d>& w) const {
    const VectorOf<d> f = w.template head<d>();
    const Matrix<double, turns, 1> m = w.template tail<turns>();
    Wrench<d> shifted;
    shifted << sign * (f + force(m)), sign * ratio * m;
    return shifted;
  }
  WrenchMatrix<d> matrix() const;  ///< s_F Shift

 private:
  /// arm x f
  Matrix<double, turns, 1> moment(const VectorOf<d>& f) const {
    if constexpr (d == 3)
      return arm.cross(f);
    else
      return Matrix<double, 1, 1>(arm[0] * f[1] - arm[1] * f[0]);
  }
  /// m -> -(f -> arm x f)' m
  VectorOf<d> force(const Matrix<double, turns, 1>& m) const {
    if constexpr (d == 3)
      return arm.cross(m);
    else
      return {arm[1] * m[0], -arm[0] * m[0]};
  }
};
template <int d>
WrenchShift<d> wrench_shift(const FacetTopology<d>& topology, int facet,
                            int ridge);

/// The wrench on a facet l of a cell that balances one on its facet k:
///     w_l = s Shift w_k,   m_l = (h_k m_k - (x_l - x_k) x f_k) / h_l,   s = -eta_k eta_l.
/// @param k, l  0 to d
template <int d>
WrenchShift<d> balancing_shift(const FacetTopology<d>& topology, int cell,
                               int k, int l);

/// The place on facet k of a cell, in the facet's own order, of its vertex j in the cell's
/// (vertex_of_facet).
template <int d>
int place_on_own(const SimplexMesh<d>& mesh, const Facets<d>& facets, int cell,
                 int k, int j) {
  return facets.place_of(mesh.cells(vertex_of_facet<d>(k, j), cell),
                         facets.of_cell(k, cell));
}

/// The columns of facet_energy on a cell for its facets' (w, y), as these are stored: of the
/// facet's own normal, in the order of its vertices.
template <int d>
std::array<FacetMatrix<d>, d + 1> wrench_bases(const FacetTopology<d>& topology,
                                               int cell);

}  // namespace ffcontact
