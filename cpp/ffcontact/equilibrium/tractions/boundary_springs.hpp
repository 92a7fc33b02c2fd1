// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ffcontact/equilibrium/tractions/facet_quadrature.hpp"
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

namespace ffcontact {

/// Springs on the boundary, an elastic foundation: a displacement u is answered by the
/// traction
///     t = -K (u - u_0),   K symmetric and >= 0,
/// beside the given ones. K and u_0 are known at the points of FacetQuadrature of each
/// column of SimplexMesh::boundary, by which all integrals with K are taken.
template <int d>
struct BoundarySprings {
  static constexpr int points = FacetQuadrature<d>::points,
                       components = d * (d + 1) / 2;

  /// K at the points, its lower triangle column by column: (K_xx, K_xy, K_yy), in space
  /// (K_xx, K_xy, K_xz, K_yy, K_yz, K_zz) [N/mm^3, components * points x boundary]; no
  /// columns: no springs
  Matrix<double, components * points, Dynamic> stiffness;
  Matrix<double, d * points, Dynamic> rest;  ///< u_0 there [mm]

  BoundarySprings() : stiffness(components * points, 0), rest(d * points, 0) {}
  /// None on so many columns.
  explicit BoundarySprings(Index columns) {
    stiffness.setZero(components * points, columns);
    rest.setZero(d * points, columns);
  }

  bool empty() const { return stiffness.cols() == 0; }
  bool on(Index column) const {
    return !empty() && !stiffness.col(column).isZero(0);
  }
  MatrixOf<d> stiffness_at(int point, Index column) const {
    const auto k =
        stiffness.col(column).segment(components * point, components);
    MatrixOf<d> K;
    for (int j = 0, next = 0; j < d; ++j)
      for (int i = j; i < d; ++i) K(i, j) = K(j, i) = k[next++];
    return K;
  }
  VectorOf<d> rest_at(int point, Index column) const {
    return rest.template block<d, 1>(d * point, column);
  }
};

/// The projector on what the springs of a column can answer: 0, n n' for springs along n
/// alone, or 1.
/// @throws std::invalid_argument  if that is not the same at all points
template <int d>
MatrixOf<d> answered_directions(const SimplexMesh<d>& mesh,
                                const BoundarySprings<d>& springs,
                                Index column);

/// @throws std::invalid_argument  if sizes differ, K is not finite and >= 0, or its
///                                range differs along a facet
template <int d>
void require_valid(const SimplexMesh<d>& mesh,
                   const BoundarySprings<d>& springs);

/// @param facets  of the mesh, of contact: their tractions and those of springs could not
///                be told apart
/// @throws std::invalid_argument  if there are springs on one
template <int d>
void require_no_springs_on(const Facets<d>& facets,
                           const std::vector<int>& contact,
                           const BoundarySprings<d>& springs);

/// Moments of -K (u - u_0) at the vertices of each column of SimplexMesh::boundary [d^2 x
/// boundary, N/mm, in space N]; no columns without springs.
template <int d>
FacetColumns<d> spring_moments(const SimplexMesh<d>& mesh,
                               const BoundarySprings<d>& springs,
                               const Ref<const VectorXd>& displacement);

/// Of -K u: what they change by with u.
template <int d>
FacetColumns<d> spring_moment_changes(const SimplexMesh<d>& mesh,
                                      const BoundarySprings<d>& springs,
                                      const Ref<const VectorXd>& displacement);

/// Sum of moments of which the latter have no columns where there are no springs.
template <int d>
FacetColumns<d> with_springs(const FacetColumns<d>& given,
                             const FacetColumns<d>& springs) {
  return springs.cols() > 0 ? FacetColumns<d>(given + springs) : given;
}

/// The error of tractions t in the springs' law, and its change when the moments of t
/// change by x:
///     int (t + K (u - u_0))' K^-1 (t + K (u - u_0)) = x'H x + 2 g'x + before      [as e^2],
/// K^-1 on what the springs answer. It is twice what the energy of the springs,
/// (u - u_0)'K (u - u_0) / 2, its conjugate t'K^-1 t / 2 and the work t'(u - u_0) sum up
/// to; with it in e^2 the bounds hold for the norms with the springs' energy.
template <int d>
struct SpringError {
  FacetMatrix<d> H = FacetMatrix<d>::Zero();
  FacetVector<d> g = FacetVector<d>::Zero();
  double before = 0;
};

/// @param moments  of t, linear on the facet, at the vertices of a column
template <int d>
SpringError<d> spring_error(const SimplexMesh<d>& mesh,
                            const BoundarySprings<d>& springs,
                            const Ref<const VectorXd>& displacement,
                            const FacetVector<d>& moments, Index column);

/// What (2.11) and (2.12) take of the springs, with |t|^2 = int t' K^-1 t.
struct SpringNorms {
  VectorXd difference;  ///< |t + K (u - u_0)|^2 per column [as e^2]
  double sum = 0;       ///< |t - K (u - u_0)|^2 in all
};

/// @param tractions  moments of t [d^2 x boundary]
template <int d>
SpringNorms spring_norms(const SimplexMesh<d>& mesh,
                         const BoundarySprings<d>& springs,
                         const Ref<const VectorXd>& displacement,
                         const FacetColumns<d>& tractions);

/// Moments at the vertices of the columns of SimplexMesh::boundary as forces on all dofs.
template <int d>
VectorXd boundary_forces(const SimplexMesh<d>& mesh,
                         const FacetColumns<d>& moments);

}  // namespace ffcontact
