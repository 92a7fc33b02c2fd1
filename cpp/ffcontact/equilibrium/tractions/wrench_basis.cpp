// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/wrench_basis.hpp"

#include <Eigen/LU>
#include <cmath>

namespace ffcontact {

namespace {

/// sum of X X' of the moment matrices X of arms from the centroid
template <int d>
Matrix<double, CompositeElement<d>::turns, CompositeElement<d>::turns>
sum_of_squares(const MatrixOf<d>& arms) {
  if constexpr (d == 3)
    return arms.squaredNorm() * Matrix3d::Identity() - arms * arms.transpose();
  else
    return Matrix<double, 1, 1>(arms.squaredNorm());
}

/// Does the normal of a facet follow the right-hand turn about a ridge of it?
template <int d>
bool follows_turn(const FacetTopology<d>& topology, int facet, int ridge) {
  const auto of_facet = topology.facets.vertices.col(facet);
  const auto of_ridge = topology.ridges.vertices.col(ridge);
  if constexpr (d == 3) {
    // a face runs counter-clockwise as seen from where its normal points to
    const int first = topology.facets.place_of(of_ridge[0], facet);
    return of_facet[(first + 1) % 3] == of_ridge[1];
  } else {
    return of_facet[1] == of_ridge[0];
  }
}

/// The length of an edge, or that of the first one at a vertex.
template <int d>
double size_of_ridge(const FacetTopology<d>& topology, int ridge) {
  if constexpr (d == 3)
    return edge_vector(topology.mesh, topology.ridges, ridge).norm();
  else
    return size_of_facet<2>(
        topology.facet_corners(topology.ridges.facets_of(ridge)[0]));
}

}  // namespace

template <>
MomentMatrix<FFCONTACT_DIMENSION> moment_matrix<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, 1>& a) {
  MomentMatrix<FFCONTACT_DIMENSION> matrix;
  if constexpr (FFCONTACT_DIMENSION == 3)
    matrix << 0, -a[FFCONTACT_DIMENSION - 1], a[1], a[FFCONTACT_DIMENSION - 1],
        0, -a[0], -a[1], a[0], 0;
  else
    matrix << -a[1], a[0];
  return matrix;
}

template <int d>
double size_of_facet(const MatrixOf<d>& corners) {
  const double measure = facet_vector(corners).norm();
  return d == 3 ? std::sqrt(measure) : measure;
}

template <int d>
WrenchMoments<d> wrench_moments(const MatrixOf<d>& corners) {
  constexpr int turns = CompositeElement<d>::turns;
  const MatrixOf<d> arms =
      (corners.colwise() - corners.rowwise().mean().eval()) /
      size_of_facet<d>(corners);
  // W W', whose blocks of forces with moments are 0 about the centroid: d I and J
  const Matrix<double, turns, turns> inverse =
      sum_of_squares<d>(arms).inverse();
  WrenchMoments<d> moments = WrenchMoments<d>::Zero();
  for (int i = 0; i < d; ++i) {
    moments.template block<d, d>(d * i, 0).diagonal().setConstant(1.0 / d);
    const VectorOf<d> arm = arms.col(i);
    moments.template block<d, turns>(d * i, d) =
        moment_matrix<d>(arm).transpose() * inverse;
  }
  return moments;
}

template <int d>
FacetMatrix<d> wrench_basis(const MatrixOf<d>& corners) {
  using Element = CompositeElement<d>;
  FacetMatrix<d> V = FacetMatrix<d>::Zero();
  V.template leftCols<Element::wrench>() = wrench_moments<d>(corners);
  for (int k = 0; k < Element::modes; ++k) {
    const int a = (k + 1) % d, b = (k + 2) % d;
    const VectorOf<d> along = (corners.col(b) - corners.col(a)).normalized();
    V.col(Element::wrench + k).template segment<d>(d * a) = -along;
    V.col(Element::wrench + k).template segment<d>(d * b) = along;
  }
  return V;
}

template <int d>
WrenchMatrix<d> WrenchShift<d>::matrix() const {
  WrenchMatrix<d> shift;
  for (int k = 0; k < shift.cols(); ++k)
    shift.col(k) = times(Wrench<d>::Unit(k));
  return shift;
}

template <int d>
WrenchShift<d> wrench_shift(const FacetTopology<d>& topology, int facet,
                            int ridge) {
  const MatrixOf<d> corners = topology.facet_corners(facet);
  const VectorOf<d> arm =
      corners.rowwise().mean() -
      ridge_middle<d>(topology.mesh, topology.ridges, ridge);
  const double size = size_of_facet<d>(corners);
  return {arm / size, size_of_ridge<d>(topology, ridge) / size,
          follows_turn<d>(topology, facet, ridge) ? 1.0 : -1.0};
}

template <int d>
WrenchShift<d> balancing_shift(const FacetTopology<d>& topology, int cell,
                               int k, int l) {
  const Facets<d>& facets = topology.facets;
  const MatrixOf<d> given = topology.facet_corners(facets.of_cell(k, cell)),
                    other = topology.facet_corners(facets.of_cell(l, cell));
  const double size = size_of_facet<d>(other);
  return {(other.rowwise().mean() - given.rowwise().mean()) / size,
          size_of_facet<d>(given) / size,
          -1.0 * facets.eta(k, cell) * facets.eta(l, cell)};
}

template <int d>
std::array<FacetMatrix<d>, d + 1> wrench_bases(const FacetTopology<d>& topology,
                                               int cell) {
  const auto& [mesh, facets, ridges] = topology;
  std::array<FacetMatrix<d>, d + 1> bases;
  for (int k = 0; k <= d; ++k) {
    const int facet = facets.of_cell(k, cell);
    const double eta = facets.eta(k, cell);
    const FacetMatrix<d> V =
        eta * wrench_basis<d>(topology.facet_corners(facet));
    for (int j = 0; j < d; ++j)
      bases[k].template middleRows<d>(d * j) = V.template middleRows<d>(
          d * place_on_own<d>(mesh, facets, cell, k, j));
  }
  return bases;
}

template double size_of_facet<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&);
template WrenchMoments<FFCONTACT_DIMENSION> wrench_moments<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&);
template FacetMatrix<FFCONTACT_DIMENSION> wrench_basis<FFCONTACT_DIMENSION>(
    const Matrix<double, FFCONTACT_DIMENSION, FFCONTACT_DIMENSION>&);
template struct WrenchShift<FFCONTACT_DIMENSION>;
template WrenchShift<FFCONTACT_DIMENSION> wrench_shift(
    const FacetTopology<FFCONTACT_DIMENSION>&, int, int);
template WrenchShift<FFCONTACT_DIMENSION> balancing_shift(
    const FacetTopology<FFCONTACT_DIMENSION>&, int, int, int);
template std::array<FacetMatrix<FFCONTACT_DIMENSION>, FFCONTACT_DIMENSION + 1>
wrench_bases(const FacetTopology<FFCONTACT_DIMENSION>&, int);

}  // namespace ffcontact
