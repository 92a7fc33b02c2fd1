// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/equilibrium/tractions/boundary_springs.hpp"

#include "ffcontact/base/require.hpp"
#include "ffcontact/elastic/dofs.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/linear/dense/symmetric_eigen.hpp"
#include "ffcontact/linear/norms.hpp"

namespace ffcontact {

namespace {

/// Stiffnesses below this part of the largest one at a point are none.
constexpr double negligible_stiffness = 1e-12;

/// The sum of f(stiffness) n n' over the axes n along which K answers.
template <int d, class Function>
MatrixOf<d> over_axes(const MatrixOf<d>& K, Function&& f) {
  const SymmetricEigen axes = symmetric_eigen(K);
  MatrixOf<d> sum = MatrixOf<d>::Zero();
  for (int k = 0; k < d; ++k) {
    const VectorOf<d> n = axes.vectors.col(k);
    if (axes.values[k] > negligible_stiffness * axes.values[d - 1])
      sum += f(axes.values[k]) * n * n.transpose();
  }
  return sum;
}

template <int d>
MatrixOf<d> projector(const MatrixOf<d>& K) {
  return over_axes<d>(K, [](double) { return 1.0; });
}

/// K^-1 on its range.
template <int d>
MatrixOf<d> flexibility(const MatrixOf<d>& K) {
  return over_axes<d>(K, [](double k) { return 1 / k; });
}

/// At the vertices of a column, one column each.
template <int d>
MatrixOf<d> vertex_displacements(const SimplexMesh<d>& mesh,
                                 const Ref<const VectorXd>& displacement,
                                 Index column) {
  MatrixOf<d> u;
  for (int k = 0; k < d; ++k)
    u.col(k) = vector_at<d>(displacement, mesh.boundary(k, column));
  return u;
}

template <int d>
MatrixOf<d> density_of(const FacetVector<d>& moments, double measure) {
  const MatrixOf<d> at_vertices = moments.reshaped(d, d);
  return facet_density<d>(at_vertices, measure);
}

/// The traction at a point from its moments, a column for each.
template <int d>
Matrix<double, d, d * d> tractions_at(int point, double measure) {
  Matrix<double, d, d * d> tractions;
  for (int k = 0; k < d * d; ++k)
    tractions.col(k) = density_of<d>(FacetVector<d>::Unit(k), measure) *
                       FacetQuadrature<d>::hats(point);
  return tractions;
}

/// @param with_rest  whether u_0 counts
template <int d>
FacetColumns<d> moments_of_answers(const SimplexMesh<d>& mesh,
                                   const BoundarySprings<d>& springs,
                                   const Ref<const VectorXd>& displacement,
                                   bool with_rest) {
  using Quadrature = FacetQuadrature<d>;
  FacetColumns<d> moments =
      FacetColumns<d>::Zero(d * d, springs.stiffness.cols());
  for (Index b = 0; b < moments.cols(); ++b) {
    if (!springs.on(b)) continue;
    const MatrixOf<d> at_vertices =
        vertex_displacements<d>(mesh, displacement, b);
    const double measure = boundary_measure(mesh, b);
    for (int q = 0; q < Quadrature::points; ++q) {
      const VectorOf<d> hats = Quadrature::hats(q);
      VectorOf<d> u = at_vertices * hats;
      if (with_rest) u -= springs.rest_at(q, b);
      const VectorOf<d> answer =
          measure * Quadrature::weights[q] * springs.stiffness_at(q, b) * u;
      moments.col(b) -= (answer * hats.transpose()).reshaped();
    }
  }
  return moments;
}

/// The same with the sign of K (u - u_0).
template <int d>
SpringError<d> quadratic_form(const SimplexMesh<d>& mesh,
                              const BoundarySprings<d>& springs,
                              const Ref<const VectorXd>& displacement,
                              const FacetVector<d>& moments, Index column,
                              double sign) {
  using Quadrature = FacetQuadrature<d>;
  const double measure = boundary_measure(mesh, column);
  const MatrixOf<d> at_vertices =
                        vertex_displacements<d>(mesh, displacement, column),
                    density = density_of<d>(moments, measure);
  SpringError<d> error;
  for (int q = 0; q < Quadrature::points; ++q) {
    const VectorOf<d> hats = Quadrature::hats(q);
    const MatrixOf<d> K = springs.stiffness_at(q, column),
                      weight =
                          measure * Quadrature::weights[q] * flexibility<d>(K);
    const VectorOf<d> answer =
        K * (at_vertices * hats - springs.rest_at(q, column));
    const VectorOf<d> off = density * hats + sign * answer,
                      weighted = weight * off;
    const auto t = tractions_at<d>(q, measure);
    error.H += t.transpose() * weight * t;
    error.g += t.transpose() * weighted;
    error.before += off.dot(weighted);
  }
  return error;
}

template <int d>
void require_stiffness(const MatrixOf<d>& K, const VectorOf<d>& rest,
                       const VectorOf<d>& place) {
  if (!K.allFinite() || !rest.allFinite())
    refuse("the springs at ", in_words(place), " are not finite numbers");
  const VectorXd k = symmetric_eigen(K).values;
  if (k[0] < -negligible_stiffness * max_norm(k))
    refuse("the stiffness of the springs must not be negative; at ",
           in_words(place), " it is ", k[0], " in one direction");
}

}  // namespace

template <int d>
MatrixOf<d> answered_directions(const SimplexMesh<d>& mesh,
                                const BoundarySprings<d>& springs,
                                Index column) {
  constexpr double parallel = 1e-9;
  const MatrixOf<d> P = projector<d>(springs.stiffness_at(0, column));
  for (int q = 1; q < springs.points; ++q)
    if (!(P - projector<d>(springs.stiffness_at(q, column))).isZero(parallel))
      refuse("the springs on the boundary ", d == 2 ? "edge" : "face", " at ",
             in_words(mesh.place(mesh.boundary(0, column))),
             " answer other directions at one end than at the other: along "
             "each ",
             d == 2 ? "edge" : "face",
             " a stiffness must be zero or positive all the way");
  return P;
}

template <int d>
void require_valid(const SimplexMesh<d>& mesh,
                   const BoundarySprings<d>& springs) {
  if (springs.empty()) return;
  require_size("springs", springs.stiffness.cols(), mesh.boundary.cols());
  require_size("springs at rest", springs.rest.cols(), mesh.boundary.cols());
  for (Index b = 0; b < mesh.boundary.cols(); ++b) {
    for (int q = 0; q < springs.points; ++q)
      require_stiffness<d>(springs.stiffness_at(q, b), springs.rest_at(q, b),
                           mesh.place(mesh.boundary(0, b)));
    answered_directions(mesh, springs, b);
  }
}

template <int d>
FacetColumns<d> spring_moments(const SimplexMesh<d>& mesh,
                               const BoundarySprings<d>& springs,
                               const Ref<const VectorXd>& displacement) {
  return moments_of_answers<d>(mesh, springs, displacement, true);
}

template <int d>
FacetColumns<d> spring_moment_changes(const SimplexMesh<d>& mesh,
                                      const BoundarySprings<d>& springs,
                                      const Ref<const VectorXd>& displacement) {
  return moments_of_answers<d>(mesh, springs, displacement, false);
}

template <int d>
SpringError<d> spring_error(const SimplexMesh<d>& mesh,
                            const BoundarySprings<d>& springs,
                            const Ref<const VectorXd>& displacement,
                            const FacetVector<d>& moments, Index column) {
  return quadratic_form<d>(mesh, springs, displacement, moments, column, 1);
}

template <int d>
SpringNorms spring_norms(const SimplexMesh<d>& mesh,
                         const BoundarySprings<d>& springs,
                         const Ref<const VectorXd>& displacement,
                         const FacetColumns<d>& tractions) {
  SpringNorms norms{VectorXd::Zero(springs.stiffness.cols())};
  const auto square = [&](Index b, double sign) {
    return quadratic_form<d>(mesh, springs, displacement, tractions.col(b), b,
                             sign)
        .before;
  };
  for (Index b = 0; b < norms.difference.size(); ++b) {
    if (!springs.on(b)) continue;
    norms.difference[b] = square(b, 1);
    norms.sum += square(b, -1);
  }
  return norms;
}

template <int d>
VectorXd boundary_forces(const SimplexMesh<d>& mesh,
                         const FacetColumns<d>& moments) {
  VectorXd forces = VectorXd::Zero(mesh.vertices.size());
  for (Index b = 0; b < moments.cols(); ++b)
    for (int k = 0; k < d; ++k)
      forces.segment<d>(d * mesh.boundary(k, b)) +=
          moments.template block<d, 1>(d * k, b);
  return forces;
}

template <int d>
void require_no_springs_on(const Facets<d>& facets,
                           const std::vector<int>& contact,
                           const BoundarySprings<d>& springs) {
  for (int f : contact)
    if (springs.on(facets.boundary_index[f]))
      refuse("the springs are on the contact ", d == 2 ? "line" : "surface",
             ", at the ", d == 2 ? "edge" : "face", " between vertices ",
             facets.vertices(0, f), " and ", facets.vertices(d - 1, f),
             ": give them on other labels");
}

template MatrixOf<FFCONTACT_DIMENSION> answered_directions(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&, Index);
template void require_valid(const SimplexMesh<FFCONTACT_DIMENSION>&,
                            const BoundarySprings<FFCONTACT_DIMENSION>&);
template FacetColumns<FFCONTACT_DIMENSION> spring_moments(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&);
template FacetColumns<FFCONTACT_DIMENSION> spring_moment_changes(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&);
template SpringError<FFCONTACT_DIMENSION> spring_error(
    const SimplexMesh<FFCONTACT_DIMENSION>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&, const Ref<const VectorXd>&,
    const FacetVector<FFCONTACT_DIMENSION>&, Index);
template SpringNorms spring_norms(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                  const BoundarySprings<FFCONTACT_DIMENSION>&,
                                  const Ref<const VectorXd>&,
                                  const FacetColumns<FFCONTACT_DIMENSION>&);
template VectorXd boundary_forces(const SimplexMesh<FFCONTACT_DIMENSION>&,
                                  const FacetColumns<FFCONTACT_DIMENSION>&);
template void require_no_springs_on(
    const Facets<FFCONTACT_DIMENSION>&, const std::vector<int>&,
    const BoundarySprings<FFCONTACT_DIMENSION>&);

}  // namespace ffcontact
