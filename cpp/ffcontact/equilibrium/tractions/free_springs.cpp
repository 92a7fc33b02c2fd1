// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/free_springs.hpp"

#include <cmath>

#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Directions closer than this to an axis are that axis.
constexpr double on_axis = 1e-12;

template <int d>
bool is_diagonal(const MatrixOf<d>& K) {
  const MatrixOf<d> off = K - MatrixOf<d>(K.diagonal().asDiagonal());
  return max_norm(off) <= on_axis * max_norm(K);
}

template <int d>
bool is_diagonal(const BoundarySprings<d>& springs, Index column) {
  for (int q = 0; q < springs.points; ++q)
    if (!is_diagonal<d>(springs.stiffness_at(q, column))) return false;
  return true;
}

/// Takes moments in the order of a facet's vertices to those of its column of
/// SimplexMesh::boundary, of which what P keeps.
template <int d>
FacetMatrix<d> to_column(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                         int facet, const MatrixOf<d>& P) {
  FacetMatrix<d> map = FacetMatrix<d>::Zero();
  for (int k = 0; k < d; ++k) {
    const int place =
        facets.place_of(mesh.boundary(k, facets.boundary_index[facet]), facet);
    map.template block<d, d>(d * k, d * place) = P;
  }
  return map;
}

/// What springs answer and no support does.
template <int d>
MatrixOf<d> free_directions(const SimplexMesh<d>& mesh,
                            const BoundarySprings<d>& springs, Index column,
                            const Eigen::Array<bool, d, 1>& known) {
  MatrixOf<d> P = answered_directions(mesh, springs, column);
  if (known.all()) return P;
  if (!is_diagonal(springs, column)) return MatrixOf<d>::Zero();
  for (int c = 0; c < d; ++c)
    if (!known[c]) P(c, c) = 0;
  return P;
}

/// Directions of a facet that are known no longer.
template <int d>
void release(const FreeSpring<d>& spring, FacetTractions<d>& boundary) {
  const auto& [facet, P, error] = spring;
  auto known = boundary.known.col(facet);
  for (int c = 0; c < d; ++c)
    if (P(c, c) > on_axis) known[c] = false;
  if (is_diagonal<d>(P)) return;
  const SymmetricEigen axes = symmetric_eigen(P);  // of 0, then of 1
  boundary.known_direction[facet] =
      axes.vectors.leftCols((axes.values.array() < 0.5).count());
}

}  // namespace

template <int d>
std::vector<FreeSpring<d>> free_springs(const SimplexMesh<d>& mesh,
                                        const Facets<d>& facets,
                                        const BoundarySprings<d>& springs,
                                        const FacetTractions<d>& boundary,
                                        const Ref<const VectorXd>& displacement,
                                        const FacetColumns<d>& tractions) {
  std::vector<FreeSpring<d>> free;
  for (int f = 0; f < facets.count(); ++f) {
    const int b = facets.boundary_index[f];
    if (b < 0 || !springs.on(b)) continue;
    const MatrixOf<d> P =
        free_directions<d>(mesh, springs, b, boundary.known.col(f));
    if (P.isZero(0)) continue;
    const SpringError<d> error =
        spring_error<d>(mesh, springs, displacement, tractions.col(b), b);
    const FacetMatrix<d> keep = to_column<d>(mesh, facets, f, P);
    free.push_back({f,
                    P,
                    {keep.transpose() * error.H * keep,
                     keep.transpose() * error.g, error.before}});
  }
  return free;
}

template <int d>
FacetTractions<d> released(FacetTractions<d> boundary,
                           const std::vector<FreeSpring<d>>& springs) {
  for (const FreeSpring<d>& spring : springs) release<d>(spring, boundary);
  return boundary;
}

template <int d>
void add_spring_changes(const SimplexMesh<d>& mesh, const Facets<d>& facets,
                        const std::vector<FreeSpring<d>>& springs,
                        const FacetTractions<d>& boundary,
                        const FacetColumns<d>& moments,
                        FacetColumns<d>& tractions) {
  for (const auto& [facet, P, error] : springs)
    tractions.col(facets.boundary_index[facet]) +=
        to_column<d>(mesh, facets, facet, P) *
        (moments.col(facet) - boundary.moments.col(facet));
}

template std::vector<FreeSpring<FFCONTACT_DIMENSION>> free_springs(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&,
    const FacetTractions<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&,
    const FacetColumns<FFCONTACT_DIMENSION>&);
template FacetTractions<FFCONTACT_DIMENSION> released(
    FacetTractions<FFCONTACT_DIMENSION>,
    const std::vector<FreeSpring<FFCONTACT_DIMENSION>>&);
template void add_spring_changes(
    const SimplexMesh<FFCONTACT_DIMENSION>&, const Facets<FFCONTACT_DIMENSION>&,
    const std::vector<FreeSpring<FFCONTACT_DIMENSION>>&,
    const FacetTractions<FFCONTACT_DIMENSION>&,
    const FacetColumns<FFCONTACT_DIMENSION>&,
    FacetColumns<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
