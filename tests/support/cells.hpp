// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "ffcontact/equilibrium/stress/cell_geometry.hpp"
#include "ffcontact/equilibrium/stress/composite_element.hpp"
#include "ffcontact/equilibrium/stress/facet_density.hpp"
#include "ffcontact/equilibrium/tractions/equilibrium_defect.hpp"
#include "support/random.hpp"

/// Equilibrium of one triangle or tetrahedron in force and moment.
namespace ffcontact::test {

/// A cell of about the size 1 that is not thin (composite_stress).
template <int d>
CellCorners<d> random_cell(Random& random) {
  for (;;) {
    const CellCorners<d> corners = random_matrix(d, d + 1, random);
    if (piola_matrix<d>(corners).determinant() > (d == 2 ? 0.7 : 0.4))
      return corners;
  }
}

/// An elastic law, or the inverse of one: symmetric and positive definite, coupling all
/// components.
template <int d>
VoigtMatrix<d> random_law(Random& random) {
  const VoigtMatrix<d> A = random_matrix(voigt_size<d>, voigt_size<d>, random);
  return A * A.transpose() + 0.2 * VoigtMatrix<d>::Identity();
}

/// Moment of a force with this arm, as a matrix.
inline Matrix<double, 1, 2> moment_matrix(const Vector2d& arm) {
  return {-arm.y(), arm.x()};
}
inline Matrix3d moment_matrix(const Vector3d& arm) {
  Matrix3d matrix;
  matrix << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  return matrix;
}

template <int d>
constexpr int forces_of_cell = (d + 1) * (d + 1);

/// Rows: force, and moment about the barycentre, of the facet loads and the body loads. All
/// act at the vertices, since x = sum of x_i phi_i.
template <int d>
Matrix<double, CompositeElement<d>::wrench, d * forces_of_cell<d>>
balance_conditions(const CellCorners<d>& corners) {
  const VectorOf<d> centre = corners.rowwise().mean();
  constexpr int on_facets = d * (d + 1);
  Matrix<double, CompositeElement<d>::wrench, d * forces_of_cell<d>> conditions;
  for (int force = 0; force < forces_of_cell<d>; ++force) {
    const int vertex = force < on_facets
                           ? vertex_of_facet<d>(force / d, force % d)
                           : force - on_facets;
    const VectorOf<d> arm = corners.col(vertex) - centre;
    conditions.template middleCols<d>(d * force) << MatrixOf<d>::Identity(),
        moment_matrix(arm);
  }
  return conditions;
}

/// Force, and moment over the longest edge from vertex 0.
template <int d>
Matrix<double, CompositeElement<d>::wrench, 1> out_of_balance(
    const CellCorners<d>& corners, const FacetLoads<d>& on_facets,
    const CellBodyLoads<d>& in_body) {
  Matrix<double, d * forces_of_cell<d>, 1> loads;
  loads << on_facets.reshaped(), in_body.reshaped();
  Matrix<double, CompositeElement<d>::wrench, 1> result =
      balance_conditions<d>(corners) * loads;
  result.template tail<CompositeElement<d>::turns>() /=
      piola_matrix<d>(corners).colwise().norm().maxCoeff();
  return result;
}

template <int d>
struct Loads {
  FacetLoads<d> on_facets;
  CellBodyLoads<d> in_body;
};

/// Random loads of about 1 in equilibrium.
template <int d>
Loads<d> balanced_loads(const CellCorners<d>& corners, Random& random) {
  const MatrixXd kernel =
      MatrixXd(balance_conditions<d>(corners)).fullPivLu().kernel();
  const VectorXd loads = kernel * random_vector(kernel.cols(), random);
  constexpr int on_facets = CompositeElement<d>::loads;
  return {loads.head<on_facets>().reshaped(d, d * (d + 1)),
          loads.tail<d*(d + 1)>().reshaped(d, d + 1)};
}

/// A stress that is linear over a whole cell, Voigt: S (1, x).
template <int d>
struct LinearStress {
  Matrix<double, voigt_size<d>, d + 1> S;

  explicit LinearStress(Random& random)
      : S(random_matrix(voigt_size<d>, d + 1, random)) {}
  VoigtVector<d> at(const VectorOf<d>& x) const {
    return S.col(0) + S.template rightCols<d>() * x;
  }
  /// f = -div sigma
  VectorOf<d> body_force() const {
    VectorOf<d> f = VectorOf<d>::Zero();
    for (int i = 0; i < d; ++i)
      f -= traction(S.col(1 + i), VectorOf<d>::Unit(i));
    return f;
  }
  SubcellStress<d> values(const CellCorners<d>& x) const {
    SubcellStress<d> stress;
    for (int k = 0; k <= d; ++k) {
      for (int j = 0; j < d; ++j)
        stress.col((d + 1) * k + j) = at(x.col((k + 1 + j) % (d + 1)));
      stress.col((d + 1) * k + d) = at(x.rowwise().mean());
    }
    return stress;
  }
  Loads<d> loads(const CellCorners<d>& x) const {
    Loads<d> result;
    const CellCorners<d> vectors = facet_vectors<d>(x);
    for (int k = 0; k <= d; ++k) {
      MatrixOf<d> density;
      for (int j = 0; j < d; ++j)
        density.col(j) =
            traction(at(x.col((k + 1 + j) % (d + 1))), vectors.col(k));
      result.on_facets.template middleCols<d>(d * k) =
          facet_moments_of<d>(density, 1);
      result.in_body.col(k) = volume_of(x) / (d + 1) * body_force();
    }
    return result;
  }
};

}  // namespace ffcontact::test
