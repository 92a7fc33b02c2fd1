// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "ffcontact/equilibrium/stress/stress_conditions.hpp"
#include "ffcontact/equilibrium/tractions/facet_quadrature.hpp"
#include "ffcontact/equilibrium/tractions/facet_tractions.hpp"
//
#include "freefem/plane_point.hpp"
#include "freefem/solid_point.hpp"

/// Expressions of the script at points of one body.
namespace ffcontact::plugin {

template <int d>
using PointOf = std::conditional_t<d == 2, PlanePoint, SolidPoint>;

/// Components, all of them null where they are not given.
template <int d>
using VectorExpression = std::array<Expression, d>;

/// A quadrature on the cells of a mesh.
template <int d>
struct CellQuadrature {
  Matrix<double, d + 1, Dynamic> hats;  ///< hat functions at the points
  VectorXd weights;                     ///< in parts of the volume
};

/// That which FreeFEM's int2d or int3d uses by default.
template <int d>
CellQuadrature<d> cell_quadrature() {
  const auto& points = [] {
    if constexpr (d == 2)
      return (Fem2D::QuadratureFormular_T_5);
    else
      return (Fem2D::QuadratureFormular_Tet_5);
  }();
  CellQuadrature<d> quadrature{Matrix<double, d + 1, Dynamic>(d + 1, points.n),
                               VectorXd(points.n)};
  for (int q = 0; q < points.n; ++q) {
    auto hats = quadrature.hats.col(q);
    hats[1] = points[q].x;
    hats[2] = points[q].y;
    if constexpr (d == 3) hats[3] = points[q].z;
    hats[0] = 1 - hats.tail(d).sum();
    quadrature.weights[q] = points[q].a;
  }
  return quadrature;
}

/// An expression at places of the body's boundary (x, y, label, N).
template <int d>
VectorXd at_boundary(Stack stack, Expression expression,
                     const BodyPart<d>& part,
                     const std::vector<BoundaryPlace<d>>& places) {
  if (part.elsewhere)
    return part.elsewhere->values(expression, part.body, places);
  VectorXd values(count_of(places));
  PointOf<d> point(stack, part);
  for (int i = 0; i < count_of(places); ++i) {
    point.go_to(places[i]);
    values[i] = point.value(expression);
  }
  return values;
}

/// An expression at the centroid of each cell (x, y, region) [cells].
template <int d>
VectorXd at_cells(Stack stack, Expression expression, const BodyPart<d>& part) {
  VectorXd values(part.cell_count());
  PointOf<d> point(stack, part);
  for (int t = 0; t < values.size(); ++t) {
    point.go_to_cell(t, VectorOf<d + 1>::Constant(1.0 / (d + 1)));
    values[t] = point.value(expression);
  }
  return values;
}

/// An expression at places of every boundary element, by the hat functions of its vertices
/// there, 0 where it is null [places x boundary].
template <int d>
MatrixXd along_boundary(Stack stack, Expression expression,
                        const BodyPart<d>& part,
                        const Matrix<double, d, Dynamic>& hats) {
  MatrixXd values = MatrixXd::Zero(hats.cols(), part.boundary_count());
  if (!expression) return values;
  PointOf<d> point(stack, part);
  for (int f = 0; f < values.cols(); ++f)
    for (Index q = 0; q < values.rows(); ++q) {
      point.go_to({f, hats.col(q)});
      values(q, f) = point.value(expression);
    }
  return values;
}

/// The hat functions at the points of FacetQuadrature, which is that of FreeFEM's int1d and
/// int2d by default.
template <int d>
Matrix<double, d, Dynamic> facet_quadrature_hats() {
  Matrix<double, d, Dynamic> hats(d, FacetQuadrature<d>::points);
  for (int q = 0; q < hats.cols(); ++q)
    hats.col(q) = FacetQuadrature<d>::hats(q);
  return hats;
}

/// Moments int F phi of a traction at the vertices of every boundary element [d^2 x
/// boundary], so that they are the loads of the script.
template <int d>
FacetColumns<d> traction_moments(Stack stack, const VectorExpression<d>& F,
                                 const BodyPart<d>& part) {
  const Matrix<double, d, Dynamic> hats = facet_quadrature_hats<d>();
  FacetColumns<d> moments = FacetColumns<d>::Zero(d * d, part.boundary_count());
  if (!F[0]) return moments;
  for (int c = 0; c < d; ++c) {
    const MatrixXd values = along_boundary<d>(stack, F[c], part, hats);
    for (int f = 0; f < values.cols(); ++f) {
      const double measure =
          boundary_measure(part.mesh, part.first_boundary + f);
      for (Index q = 0; q < values.rows(); ++q)
        for (int k = 0; k < d; ++k)
          moments(d * k + c, f) += measure * FacetQuadrature<d>::weights[q] *
                                   hats(k, q) * values(q, f);
    }
  }
  return moments;
}

/// Components at points of one cell, 0 where they are not given [size x points].
template <int d, std::size_t size>
Matrix<double, static_cast<int>(size), Dynamic> in_cell(
    PointOf<d>& point, int t, const std::array<Expression, size>& expression,
    const Matrix<double, d + 1, Dynamic>& hats) {
  Matrix<double, static_cast<int>(size), Dynamic> values(size, hats.cols());
  if (!expression[0]) return values.setZero();
  for (Index q = 0; q < hats.cols(); ++q) {
    point.go_to_cell(t, hats.col(q));
    for (std::size_t c = 0; c < size; ++c)
      values(c, q) = point.value(expression[c]);
  }
  return values;
}

/// Body forces as the loads of the script.
template <int d>
struct BodyForce {
  /// int f phi_i per cell, by cell_quadrature
  BodyLoadsOfCells<d> loads;
  /// (sum over cells of (h / pi)^2 |f - f~|^2)^(1/2), h^d = d! times the cell's measure, f~
  /// the force of composite_stress [N]
  double oscillation = 0;
};

/// |f - f~|^2 in parts of the cell's measure; f~ is constant on the subcells, and subcell k
/// holds the points where phi_k is the smallest.
template <int d>
double oscillation_square(const Matrix<double, d, Dynamic>& f,
                          const CellQuadrature<d>& quadrature,
                          const Matrix<double, d, d + 1>& constant) {
  double square = 0;
  for (Index q = 0; q < f.cols(); ++q) {
    Index k;
    quadrature.hats.col(q).minCoeff(&k);
    square +=
        quadrature.weights[q] * (f.col(q) - constant.col(k)).squaredNorm();
  }
  return square;
}

template <int d>
BodyForce<d> body_force_loads(Stack stack, const VectorExpression<d>& f,
                              const BodyPart<d>& part) {
  BodyForce<d> force{BodyLoadsOfCells<d>::Zero(d * (d + 1), part.cell_count())};
  if (!f[0]) return force;
  const CellQuadrature<d> quadrature = cell_quadrature<d>();
  PointOf<d> point(stack, part);
  for (int t = 0; t < force.loads.cols(); ++t) {
    const double measure = signed_volume(part.mesh, part.first_cell + t),
                 h = std::pow((d == 2 ? 2 : 6) * measure, 1.0 / d);
    const Matrix<double, d, Dynamic> values =
        in_cell<d>(point, t, f, quadrature.hats);
    const CellBodyLoads<d> loads = measure * values *
                                   quadrature.weights.asDiagonal() *
                                   quadrature.hats.transpose();
    force.loads.col(t) = loads.reshaped();
    force.oscillation +=
        h * h / (M_PI * M_PI) * measure *
        oscillation_square<d>(values, quadrature,
                              body_force_of<d>(loads, measure));
  }
  force.oscillation = std::sqrt(force.oscillation);
  return force;
}

}  // namespace ffcontact::plugin
